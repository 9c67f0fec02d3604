"""Terrain from a server on this machine, which serves Vesuvius and misbehaves."""

import base64
import functools
import gzip
import io
import threading
import zipfile
import zlib

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

#: The bundled DEM's outermost cell centres.
WINDOW = "14.35,14.519722222,40.760277778,40.9 [EPSG:4326]"
SMALL = "14.4,14.45,40.8,40.85 [EPSG:4326]"


@pytest.fixture(scope="session")
def vesuvius_gzipped(vesuvius_tile):
    return gzip.compress(vesuvius_tile.tobytes(), 1)


@pytest.fixture
def fetch(run, tile_server, tmp_path, feedback):
    """Download from a folder of the server; returns the results."""

    def download(folder="tiles", ending=".hgt.gz", **changes):
        return run(
            "downloadsrtm",
            {
                "EXTENT": SMALL,
                "SOURCE": f"{tile_server.url}/{folder}/{{latitude}}/{{tile}}{ending}",
                "CACHE": str(tmp_path / "cache"),
                "TIMEOUT": 20,
                "RETRIES": 0,
                "DEM": str(tmp_path / "dem.tif"),
                **changes,
            },
            feedback,
        )

    return download


@pytest.fixture
def refused(fetch, tmp_path):
    """Return the sentence with which a download fails, having left nothing behind."""
    from qgis.core import QgsProcessingException

    def sentence(*arguments, **changes):
        with pytest.raises(QgsProcessingException) as failure:
            fetch(*arguments, **changes)
        assert not [path for path in tmp_path.iterdir() if path.name != "cache"]
        assert not list((tmp_path / "cache").rglob("*.*"))
        text = str(failure.value)
        assert "Traceback" not in text
        return text

    return sentence


def read(path):
    dataset = gdal.Open(str(path))
    return dataset.ReadAsArray(), dataset.GetGeoTransform(), dataset


def test_the_dem_is_the_original_in_its_window(
    fetch, run, tile_server, vesuvius_gzipped, vesuvius, tmp_path
):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    results = fetch(EXTENT=WINDOW)
    heights, geotransform, dataset = read(results["DEM"])
    original, original_geotransform, _ = read(vesuvius["DEM"])
    assert geotransform == pytest.approx(original_geotransform, abs=1e-9)
    assert np.array_equal(heights, original)
    numbers = ("TILES", "CACHED_TILES", "SEA_TILES", "VOID_PIXELS", "FILLED_PIXELS")
    assert {name: results[name] for name in numbers} == dict.fromkeys(numbers, 0) | {"TILES": 1}
    assert dataset.GetRasterBand(1).GetUnitType() == "m"
    # And the main job says the same with it as with the original.
    thicknesses = []
    for name, dem in (("a", vesuvius["DEM"]), ("b", results["DEM"])):
        done = run("radiography", {**vesuvius, "DEM": dem,
                                   "THICKNESS": str(tmp_path / f"{name}.tif"),
                                   "FLUX": str(tmp_path / f"{name}_flux.tif")})  # fmt: skip
        thicknesses.append(read(done["THICKNESS"])[0])
    assert np.nanmax(thicknesses[0]) > 1000
    assert np.allclose(*thicknesses, atol=1e-3, equal_nan=True)


def test_every_packing_and_a_folder_on_disk(
    fetch, tile_server, vesuvius_tile, vesuvius_gzipped, tmp_path
):
    plain = vesuvius_tile.tobytes()
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file:
        file.writestr("N40E014.hgt", plain)
    tile_server.files |= {
        "/tiles/N40/N40E014.hgt": plain,
        "/tiles/N40/N40E014.hgt.zip": archive.getvalue(),
        "/tiles/N40/N40E014.hgt.gz": vesuvius_gzipped,
    }
    # Packed for the journey by a server that was not asked to.
    tile_server.behaviours["/tiles/N40/N40E014"] = lambda handler: handler.answer(
        200, vesuvius_gzipped, Content_Encoding="gzip"
    )
    (tmp_path / "N40E014.hgt").write_bytes(plain)
    heights = [
        read(fetch(ending=ending)["DEM"])[0] for ending in (".hgt.gz", ".hgt", ".hgt.zip", "")
    ]
    on_disk = fetch(
        SOURCE=(tmp_path / "{tile}.hgt").as_uri().replace("%7B", "{").replace("%7D", "}")
    )
    heights.append(read(on_disk["DEM"])[0])
    assert heights[0].max() > 1000
    assert all(np.array_equal(heights[0], one) for one in heights)


def test_sea_and_voids_are_told_and_filled(fetch, tile_server, vesuvius_tile, feedback, tmp_path):
    spoilt = vesuvius_tile.copy()
    # 10 × 20 cells on the flank: 14.425° east, 40.83° north.
    spoilt[612:622, 1530:1550] = -32768
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = gzip.compress(spoilt.tobytes(), 1)
    extent = "13.9,14.45,40.8,40.85 [EPSG:4326]"
    results = fetch(EXTENT=extent)
    assert (results["TILES"], results["SEA_TILES"], results["VOID_PIXELS"]) == (2, 1, 200)
    assert any("no tile N40E013" in warning for warning in feedback.warnings)
    assert any(warning.startswith("200 cells (") for warning in feedback.warnings)
    heights, _, dataset = read(results["DEM"])
    assert np.count_nonzero(heights == dataset.GetRasterBand(1).GetNoDataValue()) == 200
    assert (heights[:, :360] == 0).all()
    filled = fetch(EXTENT=extent, FILL_VOIDS=True)
    assert (filled["VOID_PIXELS"], filled["FILLED_PIXELS"]) == (0, 200)
    truth = vesuvius_tile[612:622, 1530:1550].astype(float)
    # Interpolated over 150 m to the middle; the flank rises by 250 m across the hole.
    errors = read(filled["DEM"])[0][heights == -32768] - truth.ravel()
    assert np.abs(errors).mean() < 20


def test_a_server_that_recovers_is_asked_again(fetch, tile_server, vesuvius_gzipped):
    answers = [503, 429]

    def recover(handler):
        if answers:
            handler.answer(answers.pop(), b"not now")
        else:
            handler.answer(200, vesuvius_gzipped)

    tile_server.behaviours["/tiles/N40/N40E014.hgt.gz"] = recover
    results = fetch(RETRIES=2)
    assert results["SEA_TILES"] == 0
    assert len(tile_server.requests) == 3


def test_kept_tiles_need_no_server(fetch, tile_server, vesuvius_gzipped, feedback):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    first = read(fetch()["DEM"])[0]
    tile_server.files.clear()
    again = fetch(EXTENT="450000,455000,4517000,4522000 [EPSG:32633]")
    assert again["CACHED_TILES"] == 1
    assert len(tile_server.requests) == 1
    assert first.max() > 1000
    assert any("1 of them from the cache" in info for info in feedback.infos)


def stall(server):
    """Send half of an answer and then nothing, until the server stops."""

    def behave(handler):
        handler.send_response(200)
        handler.send_header("Content-Length", "1000000")
        handler.end_headers()
        handler.wfile.write(bytes(1000))
        handler.wfile.flush()
        server.stopped.wait(60)

    return behave


@functools.cache
def bomb():
    """Return kilobytes that become 64 MiB."""
    packer = zlib.compressobj(1, zlib.DEFLATED, 31)
    return b"".join(packer.compress(bytes(2**24)) for _ in range(4)) + packer.flush()


def misbehaviours(server):
    """Return what goes wrong, by name, and the words that must tell it."""
    page = b"<html><body>Log in first</body></html>"

    def huge(handler):
        handler.send_response(200)
        handler.send_header("Content-Length", str(10**12))
        handler.end_headers()
        server.stopped.wait(60)

    def endless(handler):
        handler.send_response(200)
        handler.end_headers()
        try:
            while not server.stopped.is_set():
                handler.wfile.write(bytes(2**20))
        except OSError:
            return

    def to(place):
        return lambda handler: handler.answer(302, Location=place)

    return {
        "html": (lambda h: h.answer(200, page), "bytes of a web page instead of 25934402"),
        "bomb": (lambda h: h.answer(200, bomb()), "gzip file that holds more than 25934402 bytes"),
        "broken": (lambda h: h.answer(200, bomb()[:5000]), "breaks off after 5000 bytes"),
        "cut": (
            lambda h: h.answer(200, bytes(500), Content_Length=1000),
            "Connection closed",
        ),
        "stalled": (stall(server), "stopped sending; try again later, or raise TIMEOUT"),
        "fault": (lambda h: h.answer(500, b"oh"), "failed: status 500; check the connection"),
        "login": (
            lambda h: h.answer(401, b"who?", WWW_Authenticate="Basic"),
            "choose an authentication (AUTHCFG)",
        ),
        "forbidden": (lambda h: h.answer(403, b"no"), "access was refused (status 403)"),
        "loop": (lambda h: h.answer(302, Location="/loop/N40/N40E014.hgt.gz"), "redirects"),
        "ping": (to("/pong/N40/N40E014.hgt.gz"), "redirects"),
        "pong": (to("/ping/N40/N40E014.hgt.gz"), "redirects"),
        "elsewhere": (to("file:///etc/passwd"), "Unknown protocol"),
        "huge": (huge, "sends 1000000000000 bytes, more than the 27000000"),
        "endless": (endless, "more than the 27000000 that a tile can have"),
        "empty": (lambda h: h.answer(200, b""), "sent 0 bytes instead of"),
        "nothing": (lambda h: h.answer(404), "none of the tiles of the extent (N40E014)"),
    }


@pytest.mark.parametrize("name", [*misbehaviours(None)])
def test_a_server_that_misbehaves_is_told_in_a_sentence(refused, tile_server, name):
    ways = misbehaviours(tile_server)
    for one, (behave, _) in ways.items():
        tile_server.behaviours[f"/{one}/N40/N40E014.hgt.gz"] = behave
    # Made before the server needs it: that takes as long as a timeout.
    bomb()
    changes = {"TIMEOUT": 0.5} if name == "stalled" else {}
    text = refused(name, ending=".hgt.gz?key=secret", **changes)
    assert ways[name][1] in text
    assert f"{tile_server.url}/{name}/".removeprefix("http") in text
    assert "secret" not in text


@pytest.fixture
def authentication(provider):
    """Store a user and password in the throw-away profile; return the id."""
    from qgis.core import QgsApplication, QgsAuthMethodConfig

    manager = QgsApplication.authManager()
    assert manager.setMasterPassword("master", True)
    config = QgsAuthMethodConfig("Basic")
    config.setName("tiles")
    config.setConfig("username", "reader")
    config.setConfig("password", "word")
    assert manager.storeAuthenticationConfig(config)
    yield config.id()
    manager.removeAuthenticationConfig(config.id())


def test_an_authentication_of_qgis_opens_a_server(
    fetch, refused, tile_server, vesuvius_gzipped, authentication
):
    def guarded(handler):
        wanted = "Basic " + base64.b64encode(b"reader:word").decode()
        if handler.headers["Authorization"] == wanted:
            handler.answer(200, vesuvius_gzipped)
        else:
            handler.answer(401, b"who?", WWW_Authenticate="Basic")

    tile_server.behaviours["/tiles/N40/N40E014.hgt.gz"] = guarded
    assert "choose an authentication" in refused()
    assert fetch(AUTHCFG=authentication)["TILES"] == 1


def test_the_proxy_of_qgis_is_used(fetch, tile_server, vesuvius_gzipped):
    from qgis.core import QgsNetworkAccessManager
    from qgis.PyQt.QtNetwork import QNetworkProxy

    manager = QgsNetworkAccessManager.instance()
    host, port = tile_server.url.removeprefix("http://").split(":")
    kinds = QNetworkProxy.ProxyType
    manager.setFallbackProxyAndExcludes(QNetworkProxy(kinds.HttpProxy, host, int(port)), [], [])
    try:
        # A proxy is asked for the whole address; no name ends in “invalid” (RFC 2606).
        tile_server.files["http://tiles.invalid/N40E014.hgt.gz"] = vesuvius_gzipped
        assert fetch(SOURCE="http://tiles.invalid/{tile}.hgt.gz")["TILES"] == 1
    finally:
        manager.setFallbackProxyAndExcludes(QNetworkProxy(kinds.NoProxy), [], [])


def test_no_server_at_all(refused, tile_server):
    tile_server.stop()
    assert "failed 2 times: " in refused(RETRIES=1)
    assert "Connection refused" in refused()


@pytest.mark.parametrize("cancel_in", ["main thread", "worker thread", "pause"])
def test_a_cancel_is_heard_while_nothing_comes(
    provider, tile_server, recorder, tmp_path, cancel_in
):
    from qgis.core import QgsProcessingContext, QgsProcessingException
    from qgis.PyQt.QtCore import QThread

    path = "/tiles/N40E014.hgt"
    asked = threading.Event()
    answer = stall(tile_server)

    def behave(handler):
        asked.set()
        if cancel_in == "pause":
            handler.answer(503, b"later")
        else:
            answer(handler)

    tile_server.behaviours[path] = behave
    feedback = recorder()
    parameters = {
        "EXTENT": SMALL, "SOURCE": f"{tile_server.url}/tiles/{{tile}}.hgt", "TIMEOUT": 60,
        "CACHE": str(tmp_path / "cache"), "RETRIES": 10, "DEM": str(tmp_path / "dem.tif"),
    }  # fmt: skip
    said = []

    def job():
        algorithm = provider.algorithm("downloadsrtm").create()
        try:
            algorithm.processAlgorithm(parameters, QgsProcessingContext(), feedback)
        except QgsProcessingException as error:
            said.append(str(error))

    class Worker(QThread):
        def run(self):
            job()

    def cancel():
        asked.wait(30)
        feedback.cancel()

    canceller = threading.Thread(target=cancel)
    canceller.start()
    if cancel_in == "main thread":
        job()
    else:
        worker = Worker()
        worker.start()
        # The server stalls for a minute: only a cancel ends it before.
        assert worker.wait(30_000)
    canceller.join()
    assert said == ["Cancelled; nothing was written."]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"EXTENT": ""}, "EXTENT is missing"),
        ({"EXTENT": "Vesuvius"}, "EXTENT is “Vesuvius”, which is no extent"),
        ({"EXTENT": "10,19,36,47 [EPSG:4326]"}, "needs 99 tiles of one degree, more than the 16"),
        ({"EXTENT": "10,11,60,61 [EPSG:4326]", "SOURCE": "srtm"}, "choose another SOURCE"),
        ({"EXTENT": "450000,455000,4517000,4522000 [EPSG:4326]"}, "beyond the globe"),
        ({"SOURCE": "aster"}, "use srtm or copernicus"),
        ({"SOURCE": "https://server/{x}.hgt"}, "holds {x}"),
        ({"MARGIN": -1}, "MARGIN is -1; give the width of the strip"),
        ({"MAX_TILES": 0}, "MAX_TILES is 0; give the number of tiles"),
        ({"MAX_TILES": 500}, "from 1 to 200"),
        ({"RETRIES": 1.5}, "not a whole number"),
        ({"TIMEOUT": 0}, "TIMEOUT is 0; give the seconds"),
        ({"TIMEOUT": "soon"}, "not a finite number"),
        ({"FILL_DISTANCE": 0}, "FILL_DISTANCE is 0; give the distance"),
        ({"AUTHCFG": "abcdefg"}, "no authentication of this profile"),
        ({"DEM": "dem.asc"}, "ends in .tif"),
        ({"CACHE": "/dev/null"}, "choose another CACHE folder"),
    ],
)
def test_input_that_cannot_be_used_is_refused(
    refused, tile_server, vesuvius_gzipped, tmp_path, changes, words
):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    if "DEM" in changes:
        changes = {"DEM": str(tmp_path / changes["DEM"])}
    assert words in refused(**changes)


def test_the_setting_is_the_default(provider):
    from qgis.core import QgsSettings

    QgsSettings().setValue("muysc/srtm_source", "https://mirror/{tile}.hgt")
    try:
        algorithm = provider.algorithm("downloadsrtm").create()
        assert algorithm.parameterDefinition("SOURCE").defaultValue() == "https://mirror/{tile}.hgt"
    finally:
        QgsSettings().remove("muysc/srtm_source")


def test_no_crs_is_degrees_and_told(fetch, tile_server, vesuvius_gzipped, feedback):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    fetch(EXTENT=SMALL.partition(" ")[0], MARGIN=1000)
    assert any("EPSG:4326 is assumed" in info for info in feedback.infos)


def test_the_layer_has_colours_of_its_heights(fetch, tile_server, vesuvius_gzipped, tmp_path):
    from qgis.core import QgsRasterLayer

    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    results = fetch()
    layer = QgsRasterLayer(results["DEM"], "dem")
    assert layer.renderer().type() == "singlebandpseudocolor"
    items = layer.renderer().shader().rasterShaderFunction().colorRampItemList()
    assert items[-1].value == pytest.approx(read(results["DEM"])[0].max(), rel=0.05)
    assert items[-1].label.endswith(" m")

"""Tiles through the network stack of QGIS, from a server that misbehaves."""

import base64
import functools
import threading
import zlib

import pytest


def test_a_server_that_recovers_is_asked_again(download, tile_server, vesuvius_gzipped):
    answers = [503, 429]

    def recover(handler):
        if answers:
            handler.answer(answers.pop(), b"not now")
        else:
            handler.answer(200, vesuvius_gzipped)

    tile_server.behaviours["/tiles/N40/N40E014.hgt.gz"] = recover
    results = download(RETRIES=2)
    assert results["SEA_TILES"] == 0
    assert len(tile_server.requests) == 3


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
def test_a_server_that_misbehaves_is_told_in_a_sentence(refused_download, tile_server, name):
    ways = misbehaviours(tile_server)
    for one, (behave, _) in ways.items():
        tile_server.behaviours[f"/{one}/N40/N40E014.hgt.gz"] = behave
    # Made before the server needs it: that takes as long as a timeout.
    bomb()
    changes = {"TIMEOUT": 0.5} if name == "stalled" else {}
    text = refused_download(name, ending=".hgt.gz?key=secret", **changes)
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
    download, refused_download, tile_server, vesuvius_gzipped, authentication
):
    def guarded(handler):
        wanted = "Basic " + base64.b64encode(b"reader:word").decode()
        if handler.headers["Authorization"] == wanted:
            handler.answer(200, vesuvius_gzipped)
        else:
            handler.answer(401, b"who?", WWW_Authenticate="Basic")

    tile_server.behaviours["/tiles/N40/N40E014.hgt.gz"] = guarded
    assert "choose an authentication" in refused_download()
    assert download(AUTHCFG=authentication)["TILES"] == 1


def test_the_proxy_of_qgis_is_used(download, tile_server, vesuvius_gzipped):
    from qgis.core import QgsNetworkAccessManager
    from qgis.PyQt.QtNetwork import QNetworkProxy

    manager = QgsNetworkAccessManager.instance()
    host, port = tile_server.url.removeprefix("http://").split(":")
    kinds = QNetworkProxy.ProxyType
    manager.setFallbackProxyAndExcludes(QNetworkProxy(kinds.HttpProxy, host, int(port)), [], [])
    try:
        # A proxy is asked for the whole address; no name ends in “invalid” (RFC 2606).
        tile_server.files["http://tiles.invalid/N40E014.hgt.gz"] = vesuvius_gzipped
        assert download(SOURCE="http://tiles.invalid/{tile}.hgt.gz")["TILES"] == 1
    finally:
        manager.setFallbackProxyAndExcludes(QNetworkProxy(kinds.NoProxy), [], [])


def test_no_server_at_all(refused_download, tile_server):
    tile_server.stop()
    assert "failed 2 times: " in refused_download(RETRIES=1)
    assert "Connection refused" in refused_download()


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
        "EXTENT": "14.4,14.45,40.8,40.85 [EPSG:4326]",
        "SOURCE": f"{tile_server.url}/tiles/{{tile}}.hgt", "TIMEOUT": 60,
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
    assert said == ["Cancelled; no output was written."]
    assert list(tmp_path.iterdir()) == []

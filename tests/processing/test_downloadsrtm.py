"""Terrain from a server on this machine, which serves Vesuvius."""

import gzip
import io
import zipfile

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

#: The bundled DEM's outermost cell centres.
WINDOW = "14.35,14.519722222,40.760277778,40.9 [EPSG:4326]"
SMALL = "14.4,14.45,40.8,40.85 [EPSG:4326]"


def read(path):
    dataset = gdal.Open(str(path))
    return dataset.ReadAsArray(), dataset.GetGeoTransform(), dataset


def test_the_dem_is_the_original_in_its_window(
    download, run, tile_server, vesuvius_gzipped, vesuvius, tmp_path
):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    results = download(EXTENT=WINDOW)
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
    download, tile_server, vesuvius_tile, vesuvius_gzipped, tmp_path
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
        read(download(ending=ending)["DEM"])[0] for ending in (".hgt.gz", ".hgt", ".hgt.zip", "")
    ]
    on_disk = download(
        SOURCE=(tmp_path / "{tile}.hgt").as_uri().replace("%7B", "{").replace("%7D", "}")
    )
    heights.append(read(on_disk["DEM"])[0])
    assert heights[0].max() > 1000
    assert all(np.array_equal(heights[0], one) for one in heights)


def test_sea_and_voids_are_told_and_filled(
    download, tile_server, vesuvius_tile, feedback, tmp_path
):
    spoilt = vesuvius_tile.copy()
    # 10 × 20 cells on the flank: 14.425° east, 40.83° north.
    spoilt[612:622, 1530:1550] = -32768
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = gzip.compress(spoilt.tobytes(), 1)
    extent = "13.9,14.45,40.8,40.85 [EPSG:4326]"
    results = download(EXTENT=extent)
    assert (results["TILES"], results["SEA_TILES"], results["VOID_PIXELS"]) == (2, 1, 200)
    assert any("no tile N40E013" in warning for warning in feedback.warnings)
    assert any(warning.startswith("200 cells (") for warning in feedback.warnings)
    heights, _, dataset = read(results["DEM"])
    assert np.count_nonzero(heights == dataset.GetRasterBand(1).GetNoDataValue()) == 200
    assert (heights[:, :360] == 0).all()
    filled = download(EXTENT=extent, FILL_VOIDS=True)
    assert (filled["VOID_PIXELS"], filled["FILLED_PIXELS"]) == (0, 200)
    truth = vesuvius_tile[612:622, 1530:1550].astype(float)
    # Interpolated over 150 m to the middle; the flank rises by 250 m across the hole.
    errors = read(filled["DEM"])[0][heights == -32768] - truth.ravel()
    assert np.abs(errors).mean() < 20


def test_terrain_without_relief_is_told(download, tile_server, vesuvius_tile, feedback):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = gzip.compress(vesuvius_tile.tobytes(), 1)
    sea = "14.1,14.1,40.1,40.1 [EPSG:4326]"
    heights = read(download(EXTENT=sea, MARGIN=0)["DEM"])[0]
    assert (heights == 0).all()
    assert [one for one in feedback.warnings if one.startswith("All heights are 0 m")]
    feedback.warnings.clear()
    download(EXTENT=SMALL)
    assert not feedback.warnings


def test_kept_tiles_need_no_server(download, tile_server, vesuvius_gzipped, feedback):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    first = read(download()["DEM"])[0]
    tile_server.files.clear()
    again = download(EXTENT="450000,455000,4517000,4522000 [EPSG:32633]")
    assert again["CACHED_TILES"] == 1
    assert len(tile_server.requests) == 1
    assert first.max() > 1000
    assert any("1 of them from the cache" in info for info in feedback.infos)


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
    refused_download, tile_server, vesuvius_gzipped, tmp_path, changes, words
):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    if "DEM" in changes:
        changes = {"DEM": str(tmp_path / changes["DEM"])}
    assert words in refused_download(**changes)


def test_the_setting_is_the_default(provider):
    from qgis.core import QgsSettings

    QgsSettings().setValue("muysc/srtm_source", "https://mirror/{tile}.hgt")
    try:
        algorithm = provider.algorithm("downloadsrtm").create()
        assert algorithm.parameterDefinition("SOURCE").defaultValue() == "https://mirror/{tile}.hgt"
    finally:
        QgsSettings().remove("muysc/srtm_source")


def test_no_crs_is_degrees_and_told(download, tile_server, vesuvius_gzipped, feedback):
    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    download(EXTENT=SMALL.partition(" ")[0], MARGIN=1000)
    assert any("EPSG:4326 is assumed" in info for info in feedback.infos)


def test_the_layer_has_colours_of_its_heights(download, tile_server, vesuvius_gzipped, tmp_path):
    from qgis.core import QgsRasterLayer

    tile_server.files["/tiles/N40/N40E014.hgt.gz"] = vesuvius_gzipped
    results = download()
    layer = QgsRasterLayer(results["DEM"], "dem")
    assert layer.renderer().type() == "singlebandpseudocolor"
    items = layer.renderer().shader().rasterShaderFunction().colorRampItemList()
    assert items[-1].value == pytest.approx(read(results["DEM"])[0].max(), rel=0.05)
    assert items[-1].label.endswith(" m")

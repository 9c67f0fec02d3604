"""Tiles put together: cell for cell, from the cache where they are in it."""

import hashlib
import subprocess
import threading

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sampling import heights_at
from muysc_qgis.topography.srtm import Extent, Tile, source_of
from muysc_qgis.topography.srtm_cache import TileCache
from muysc_qgis.topography.srtm_download import download, notes_on
from muysc_qgis.topography.srtm_mosaic import fill_voids, write_dem
from muysc_qgis.topography.srtm_tiles import VOID

gdal.UseExceptions()

SOURCE = source_of("https://word:secret@server/{tile}.hgt?key=abc")


def plane(tile, side=1201):
    """Return heights that tell their place: 100 m a degree north, 10 m a degree east."""
    latitude = tile.latitude_deg + 1 - np.arange(side)[:, None] / (side - 1)
    longitude = tile.longitude_deg + np.arange(side) / (side - 1)
    return np.rint(100 * latitude + 10 * longitude).astype(np.int16)


def packed(values):
    return values.astype(">i2").tobytes()


@pytest.fixture
def server():
    """Fetch tiles of a world where only what is in `tiles` is land."""

    class Server:
        def __init__(self):
            self.tiles, self.asked = {}, []

        def __call__(self, url, most_bytes):
            self.asked.append(url)
            assert most_bytes >= 2 * 3601**2
            name = url.rpartition("/")[2].partition(".")[0]
            return packed(self.tiles[name]) if name in self.tiles else None

        def add(self, *tiles):
            for tile in tiles:
                self.tiles[tile.name] = plane(tile)

    return Server()


@pytest.fixture
def cache(tmp_path):
    return TileCache(tmp_path / "cache", SOURCE)


def centres(mosaic):
    """Return longitudes and latitudes of the cell centres."""
    left, step_x, _, top, _, step_y = mosaic.grid.geotransform
    rows, columns = mosaic.heights.shape
    return left + step_x * (np.arange(columns) + 0.5), top + step_y * (np.arange(rows) + 0.5)


def test_four_tiles_make_one_surface(server, cache):
    server.add(Tile(40, 13), Tile(40, 14), Tile(41, 13), Tile(41, 14))
    extent = Extent(13.9, 40.8, 14.2, 41.1)
    mosaic = download(extent, SOURCE, 4, cache, server)
    longitude, latitude = centres(mosaic)
    # The extent lies within the outermost centres, by less than a cell.
    for inner, outer in (
        (extent.west_deg, longitude[0]), (longitude[-1], extent.east_deg),
        (extent.south_deg, latitude[-1]), (latitude[0], extent.north_deg),
    ):  # fmt: skip
        assert abs(inner - outer) < 1 / 1200
    assert longitude[0] <= 13.9 + 1e-9
    assert longitude[-1] >= 14.2 - 1e-9
    assert mosaic.heights.shape == (361, 361)
    expected = np.rint(100 * latitude[:, None] + 10 * longitude)
    assert np.abs(mosaic.heights - expected).max() <= 1
    assert np.mean(mosaic.heights != expected) < 0.01
    assert (mosaic.tiles, mosaic.cached_tiles, mosaic.sea_tiles) == (4, 0, ())


def test_across_the_antimeridian_longitudes_go_on(server, cache, tmp_path):
    server.add(Tile(-17, 179))
    server.tiles["S17W180"] = plane(Tile(-17, 180))
    mosaic = download(Extent(179.9, -16.6, 180.1, -16.4), SOURCE, 2, cache, server)
    longitude, latitude = centres(mosaic)
    assert (longitude[0], longitude[-1]) == pytest.approx((179.9, 180.1))
    expected = np.rint(100 * latitude[:, None] + 10 * longitude)
    assert np.abs(mosaic.heights - expected).max() <= 1
    write_dem(tmp_path / "fiji.tif", mosaic, SOURCE)
    dem = open_dem(tmp_path / "fiji.tif")
    # −179.95° is 180.05°: 100 m × −16.5 + 10 m × 180.05.
    assert heights_at(dem, *dem.grid_position(-179.95, -16.5)) == pytest.approx(150.5, abs=1)


def test_an_extent_smaller_than_a_cell_has_four(server, cache):
    server.add(Tile(40, 14))
    for west, south in ((14.50001, 40.50001), (15.0, 40.0), (14.0, 41.0), (14.5, 40.5)):
        if west in (14.0, 15.0):
            server.add(*(Tile(lat, lon) for lat in (39, 40, 41) for lon in (13, 14, 15)))
        mosaic = download(Extent(west, south, west, south), SOURCE, 1, cache, server)
        assert mosaic.heights.shape == (2, 2)


def test_missing_tiles_are_sea_and_told(server, cache):
    server.add(Tile(40, 14))
    mosaic = download(Extent(13.5, 40.5, 14.5, 40.6), SOURCE, 4, cache, server)
    longitude, _ = centres(mosaic)
    assert (mosaic.heights[:, longitude < 14 - 1e-9] == 0).all()
    assert (mosaic.heights[:, longitude > 14 - 1e-9] > 4000).all()
    assert mosaic.sea_tiles == ("N40E013",)
    notes, warnings = notes_on(mosaic, SOURCE)
    assert "no tile N40E013; it was taken as sea level" in warnings[0]
    assert any("2 tiles, 0 of them from the cache" in note for note in notes)


def test_nothing_but_missing_tiles_is_refused_without_secrets(server, cache):
    with pytest.raises(MuyscError, match=r"none of the tiles.*N40E013, N40E014.*open sea") as told:
        download(Extent(13.5, 40.5, 14.5, 40.6), SOURCE, 4, cache, server)
    assert "secret" not in str(told.value)
    assert "abc" not in str(told.value)


def geotiff(tile, values):
    """Return a tile as Copernicus has it, without its southern and eastern edge."""
    path = "/vsimem/tile.tif"
    side = len(values)
    dataset = gdal.GetDriverByName("GTiff").Create(path, side, side, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform(
        (tile.longitude_deg - 0.5 / side, 1 / side, 0,
         tile.latitude_deg + 1 + 0.5 / side, 0, -1 / side)
    )  # fmt: skip
    dataset.GetRasterBand(1).WriteArray(values)
    del dataset
    file = gdal.VSIFOpenL(path, "rb")
    content = bytes(gdal.VSIFReadL(1, gdal.VSIStatL(path).size, file))
    gdal.VSIFCloseL(file)
    gdal.Unlink(path)
    return content


def test_tiles_that_share_no_edge_join_without_a_seam(tmp_path):
    source = source_of("https://server/{tile}.tif")
    tiles = [Tile(lat, lon) for lat in (-1, 0) for lon in (-1, 0)]
    contents = {source.url(tile): geotiff(tile, plane(tile)[:1200, :1200] + 0.25) for tile in tiles}
    mosaic = download(
        Extent(-0.1, -0.1, 0.2, 0.2), source, 4, TileCache(tmp_path, source),
        lambda url, _: contents[url],
    )  # fmt: skip
    longitude, latitude = centres(mosaic)
    assert mosaic.heights.shape == (361, 361)
    assert mosaic.heights.dtype == np.float32
    assert (longitude[0], latitude[0]) == pytest.approx((-0.1, 0.2))
    expected = 100 * latitude[:, None] + 10 * longitude
    assert np.abs(mosaic.heights - 0.25 - expected).max() <= 0.5 + 1e-4
    # To the tiles' outer edges there is one cell less.
    mosaic = download(
        Extent(-1, -1, 1, 1), source, 4, TileCache(tmp_path, source), lambda url, _: None
    )
    assert mosaic.cached_tiles == 4
    assert mosaic.heights.shape == (2400, 2400)
    write_dem(tmp_path / "dem.tif", mosaic, source)
    assert np.array_equal(gdal.Open(str(tmp_path / "dem.tif")).ReadAsArray(), mosaic.heights)


def test_a_void_on_a_shared_edge_takes_the_neighbours_height(server, cache):
    server.add(Tile(40, 13), Tile(40, 14))
    server.tiles["N40E014"][600:700, 0:3] = VOID
    mosaic = download(Extent(13.9, 40.3, 14.1, 40.7), SOURCE, 2, cache, server)
    # One of the three columns is the western tile's as well.
    assert mosaic.void_cells == 200
    assert (
        f"200 cells ({200 / mosaic.heights.size:.2%}) have no height"
        in (notes_on(mosaic, SOURCE)[1][0])
    )


def test_voids_are_filled_as_far_as_asked(server, cache):
    server.add(Tile(40, 14))
    server.tiles["N40E014"][500:541, 500:541] = VOID
    mosaic = download(Extent(14.3, 40.4, 14.6, 40.7), SOURCE, 1, cache, server)
    assert mosaic.void_cells == 41**2
    full = fill_voids(mosaic, 30)
    assert (full.void_cells, full.filled_cells) == (0, 41**2)
    # A plane is symmetric around the middle of the hole: its mean is the plane's height.
    hole = mosaic.heights == VOID
    truth = plane(Tile(40, 14))[500:541, 500:541]
    assert full.heights[hole].mean() == pytest.approx(truth.mean(), abs=0.5)
    assert np.abs(full.heights[hole] - truth.ravel()).max() < 3
    assert np.array_equal(full.heights[~hole], mosaic.heights[~hole])
    near = fill_voids(mosaic, 5)
    assert 0 < near.void_cells < 41**2
    assert near.filled_cells + near.void_cells == 41**2
    assert fill_voids(full, 5) is full


def test_the_sea_floor_is_told(server, cache):
    server.add(Tile(40, 14))
    server.tiles["N40E014"][600:, :] = -1200
    mosaic = download(Extent(14.3, 40.4, 14.6, 40.7), SOURCE, 1, cache, server)
    assert "down to -1200 m: they are those of the sea floor" in notes_on(mosaic, SOURCE)[1][0]


def test_tiles_of_different_cells_are_refused(server, cache):
    server.add(Tile(40, 13))
    server.tiles["N40E014"] = plane(Tile(40, 14), 3601)
    with pytest.raises(MuyscError, match=r"N40E013 has 1200 × 1200 .* and N40E014 3600 × 3600"):
        download(Extent(13.9, 40.4, 14.1, 40.6), SOURCE, 2, cache, server)


def test_finished_tiles_are_not_fetched_again(server, cache):
    places = [Tile(40, 13), Tile(40, 14), Tile(40, 15)]
    server.add(*places)
    extent = Extent(13.5, 40.5, 15.5, 40.6)
    shares = []

    def stop_after_two(fraction):
        shares.append(fraction)
        return fraction < 0.6

    with pytest.raises(Cancelled):
        download(extent, SOURCE, 3, cache, server, stop_after_two)
    assert shares == pytest.approx([0, 1 / 3, 2 / 3])
    assert len(server.asked) == 2
    mosaic = download(extent, SOURCE, 3, cache, server)
    assert len(server.asked) == 3
    assert mosaic.cached_tiles == 2
    assert download(extent, SOURCE, 3, cache, server).cached_tiles == 3
    # Another source's tile of the same name is another tile.
    other = TileCache(cache.folder, source_of("https://other/{tile}.hgt"))
    assert other.read(Tile(40, 13)) is None


@pytest.mark.parametrize("spoil", ["flipped", "truncated", "no checksum", "wrong checksum", "huge"])
def test_a_spoilt_tile_is_fetched_again(server, cache, spoil):
    tile = Tile(40, 14)
    server.add(tile)
    extent = Extent(14.4, 40.4, 14.6, 40.6)
    before = download(extent, SOURCE, 1, cache, server)
    (data,) = cache.folder.rglob("*.tile")
    checksum = data.with_suffix(".sha256")
    content = bytearray(data.read_bytes())
    if spoil == "flipped":
        content[1000] ^= 1
        data.write_bytes(content)
    elif spoil == "truncated":
        data.write_bytes(content[:-100])
    elif spoil == "no checksum":
        checksum.unlink()
    elif spoil == "wrong checksum":
        checksum.write_bytes(b"\xff\xfe")
    else:
        with data.open("ab") as file:
            file.truncate(SOURCE.largest_bytes + 1)
    again = download(extent, SOURCE, 1, cache, server)
    assert len(server.asked) == 2
    assert np.array_equal(again.heights, before.heights)
    assert download(extent, SOURCE, 1, cache, server).cached_tiles == 1


def test_the_checksums_are_those_of_sha256sum(cache):
    cache.write(Tile(40, 14), b"content")
    (checksum,) = cache.folder.rglob("*.sha256")
    assert checksum.read_text(encoding="ascii").split()[0] == hashlib.sha256(b"content").hexdigest()
    done = subprocess.run(["sha256sum", "-c", checksum.name], cwd=checksum.parent, check=False)
    assert done.returncode == 0
    assert sorted(path.name for path in checksum.parent.iterdir()) == [
        "N40E014.sha256", "N40E014.tile",
    ]  # fmt: skip


def test_runs_that_share_a_cache_never_see_half_a_tile(cache):
    """One writer's tile may meet the other's checksum, and is not used then."""
    contents = [bytes([number]) * 300_000 for number in (1, 2)]

    def write(content):
        for _ in range(50):
            cache.write(Tile(40, 14), content)

    writers = [threading.Thread(target=write, args=(content,)) for content in contents]
    for writer in writers:
        writer.start()
    seen = {cache.read(Tile(40, 14)) for _ in range(200)}
    for writer in writers:
        writer.join()
    assert seen <= {None, *contents}
    cache.write(Tile(40, 14), contents[0])
    assert cache.read(Tile(40, 14)) == contents[0]
    assert len(list(cache.folder.rglob("*.*"))) == 2


def test_a_cache_that_cannot_be_written_is_told(server, tmp_path):
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    server.add(Tile(40, 14))
    with pytest.raises(MuyscError, match=r"cannot be kept in .*choose another CACHE folder"):
        download(
            Extent(14.4, 40.4, 14.6, 40.6), SOURCE, 1, TileCache(tmp_path / "file", SOURCE), server
        )


def test_the_file_says_where_its_heights_are_from(server, cache, tmp_path):
    server.add(Tile(40, 14))
    server.tiles["N40E014"][600, 600] = VOID
    mosaic = download(Extent(14.4, 40.4, 14.6, 40.6), SOURCE, 1, cache, server)
    write_dem(tmp_path / "dem.tif", mosaic, SOURCE)
    dataset = gdal.Open(str(tmp_path / "dem.tif"))
    band = dataset.GetRasterBand(1)
    assert np.array_equal(dataset.ReadAsArray(), mosaic.heights)
    assert (band.GetNoDataValue(), band.GetUnitType()) == (VOID, "m")
    assert dataset.GetSpatialRef().GetAuthorityCode(None) == "4326"
    assert dataset.GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE") == "DEFLATE"
    assert dataset.GetMetadataItem("SOURCE") == "https://server/{tile}.hgt"
    dem = open_dem(tmp_path / "dem.tif")
    assert np.count_nonzero(np.isnan(dem.read(0, 0, dem.columns, dem.rows))) == 1

"""Tiles as they come: every form gives the same heights, everything else is refused."""

import gzip
import io
import zipfile

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.errors import MuyscError
from muysc_qgis.topography.srtm import Tile
from muysc_qgis.topography.srtm_tiles import VOID, decode

gdal.UseExceptions()

TILE = Tile(40, 14)
ADDRESS = "https://server/N40E014.hgt"


@pytest.fixture(scope="module")
def heights():
    """A small tile, of three arc seconds, with something different in every cell of a row."""
    values = np.add.outer(np.arange(1201), 2 * np.arange(1201)).astype(np.int16)
    values[600, 700] = VOID
    return values


@pytest.fixture(scope="module")
def plain(heights):
    return heights.astype(">i2").tobytes()


def zipped(*members, **options):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members:
            archive.writestr(name, content)
    return file.getvalue()


def tiff(values, left=14 - 0.5 / 1200, top=41 + 0.5 / 1200, step=1 / 1200, step_y=None, bands=1,
         no_data=None):  # fmt: skip
    kind = gdal.GDT_Int16 if values.dtype == np.int16 else gdal.GDT_Float32
    path = "/vsimem/made.tif"
    dataset = gdal.GetDriverByName("GTiff").Create(
        path, values.shape[1], values.shape[0], bands, kind, ["COMPRESS=DEFLATE"]
    )
    dataset.SetGeoTransform((left, step, 0, top, 0, -(step_y or step)))
    if no_data is not None:
        dataset.GetRasterBand(1).SetNoDataValue(no_data)
    dataset.GetRasterBand(1).WriteArray(values)
    del dataset
    return content_of(path)


def cloud_optimized(content):
    """Return a GeoTIFF as Copernicus stores it, with its directory in front."""
    gdal.FileFromMemBuffer("/vsimem/plain.tif", content)
    plain = gdal.Open("/vsimem/plain.tif")
    dataset = gdal.GetDriverByName("COG").CreateCopy("/vsimem/cog.tif", plain)
    del dataset, plain
    gdal.Unlink("/vsimem/plain.tif")
    return content_of("/vsimem/cog.tif")


def content_of(path):
    file = gdal.VSIFOpenL(path, "rb")
    content = bytes(gdal.VSIFReadL(1, gdal.VSIStatL(path).size, file))
    gdal.VSIFCloseL(file)
    gdal.Unlink(path)
    return content


@pytest.mark.parametrize(
    "packed",
    [
        lambda plain: plain,
        gzip.compress,
        lambda plain: zipped(("N40E014.hgt", plain)),
        lambda plain: zipped(("readme.txt", b"hello"), ("folder/N40E014.HGT", plain)),
    ],
    ids=["plain", "gzip", "zip", "zip with more in it"],
)
def test_every_packing_gives_the_same_heights(heights, plain, packed):
    tile = decode(packed(plain), TILE, ADDRESS)
    assert np.array_equal(tile.values, heights)
    assert tile.values.dtype == np.int16
    assert (tile.rows_per_degree, tile.columns_per_degree) == (1200, 1200)


def test_gdal_reads_the_same_heights_from_the_same_bytes(heights, plain):
    """GDAL's driver for .hgt is an independent reader of the format."""
    path = "/vsimem/N40E014.hgt"
    gdal.FileFromMemBuffer(path, plain)
    dataset = gdal.Open(path)
    assert np.array_equal(dataset.ReadAsArray(), decode(plain, TILE, ADDRESS).values)
    # The first cell's centre is the tile's north-western corner.
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    assert (left + step_x / 2, top + step_y / 2) == pytest.approx((14, 41))
    del dataset
    gdal.Unlink(path)


def test_a_geotiff_without_its_last_edges_is_a_tile_too(heights):
    """As Copernicus publishes them: heights with fractions, 3600 or 1200 rows to a tile."""
    values = np.maximum(heights[:1200, :1200], 0).astype(np.float32) + 0.25
    values[1, 2], values[3, 4] = np.nan, -9999
    tile = decode(tiff(values, no_data=-9999), TILE, ADDRESS)
    assert (tile.rows_per_degree, tile.columns_per_degree) == (1200, 1200)
    assert (tile.values[1, 2], tile.values[3, 4]) == (VOID, VOID)
    known = tile.values != VOID
    assert np.array_equal(tile.values[known], values[known])
    assert np.count_nonzero(~known) == 2
    again = decode(cloud_optimized(tiff(values, no_data=-9999)), TILE, ADDRESS)
    assert np.array_equal(again.values, tile.values)


def test_cells_of_a_geotiff_may_be_longer_than_high():
    """Copernicus has half as many columns between 60° and 70°."""
    values = np.ones((1200, 600), np.float32)
    content = tiff(values, 20 - 0.5 / 600, 66 + 0.5 / 1200, 1 / 600, 1 / 1200)
    tile = decode(content, Tile(65, 20), ADDRESS)
    assert (tile.rows_per_degree, tile.columns_per_degree) == (1200, 600)


def test_what_is_no_tile_is_refused_in_a_sentence(heights, plain):
    page = b"<!DOCTYPE html><html><body>Please log in</body></html>"
    packed = gzip.compress(plain)
    spoilt = bytearray(packed)
    spoilt[len(spoilt) // 2] ^= 0xFF
    large = bytes(2 * 3601**2 + 2)
    high = heights.copy()
    high[5, 5] = 9001
    for payload, words in (
        (page, f"{ADDRESS} sent {len(page)} bytes of a web page instead of 25934402 or 2884802"),
        (b"", "sent 0 bytes"),
        (plain[:-2], "sent 2884800 bytes instead"),
        (packed[:-9], "breaks off"),
        (bytes(spoilt), "damaged gzip file"),
        (gzip.compress(large), "holds more than 25934402 bytes"),
        (gzip.compress(page), "bytes of a web page"),
        (zipped(("N40E014.hgt", large)), "holds more than 25934402 bytes"),
        (zipped(("N40E014.hgt", plain))[:-30], "damaged zip file"),
        (zipped(("a.hgt", plain), ("b.hgt", plain)), "2 .hgt files, not one"),
        (zipped(("readme.txt", plain)), "0 .hgt files, not one"),
        (high.astype(">i2").tobytes(), "heights from 0 to 9001 m"),
        # The least significant byte first, as some write it by mistake.
        (np.full((1201, 1201), 100, "<i2").tobytes(), "heights from 25600 to 25600 m"),
        (tiff(heights)[:2000], "or without a place"),
        (cloud_optimized(tiff(heights))[:20_000], "damaged GeoTIFF"),
        (tiff(heights, left=15 - 0.5 / 1200), "does not cover N40E014"),
        (tiff(heights, top=40 + 0.5 / 1200), "does not cover N40E014"),
        (tiff(heights[:1000]), "does not cover N40E014"),
        (tiff(heights, left=14), "does not cover N40E014"),
        (tiff(heights, step=1.0), "does not cover N40E014"),
        (tiff(heights, bands=3), "in 3 bands"),
        (tiff(np.zeros((2, 4000), np.int16)), "4000 × 2 cells"),
    ):
        with pytest.raises(MuyscError) as refused:
            decode(payload, TILE, ADDRESS)
        message = str(refused.value)
        assert words in message
        assert "which is no tile of heights; try again, check SOURCE" in message
        assert "\n" not in message


def test_a_bomb_is_not_unpacked(monkeypatch):
    """Kilobytes that would become many megabytes: the reader stops at a tile's size."""
    import zlib

    packer = zlib.compressobj(1, zlib.DEFLATED, 31)
    block = bytes(2**24)
    bomb = b"".join(packer.compress(block) for _ in range(4)) + packer.flush()
    sizes = []
    real = zlib.decompressobj

    class Watched:
        def __init__(self, bits):
            self.inner = real(bits)

        @property
        def eof(self):
            return self.inner.eof

        def decompress(self, data, most):
            out = self.inner.decompress(data, most)
            sizes.append(len(out))
            return out

    monkeypatch.setattr(zlib, "decompressobj", Watched)
    with pytest.raises(MuyscError, match="more than 25934402"):
        decode(bomb, TILE, ADDRESS)
    assert sizes == [2 * 3601**2 + 1]

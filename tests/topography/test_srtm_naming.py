"""Which tiles an extent needs, what they are called and where they are."""

import math

import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.topography.srtm import (
    SOURCES,
    Extent,
    Tile,
    public_part,
    source_of,
    tiles_of,
    widen,
)


@pytest.mark.parametrize(
    ("latitude", "longitude", "name"),
    [
        # Names of SRTM's tiles, after their south-western corner (NASA SRTM user guide).
        (40, 14, "N40E014"),
        (0, 0, "N00E000"),
        (-1, -1, "S01W001"),
        (-56, -180, "S56W180"),
        (59, 179, "N59E179"),
    ],
)
def test_tiles_are_called_after_their_south_western_corner(latitude, longitude, name):
    assert Tile(latitude, longitude).name == name


def test_public_sources_have_their_published_addresses():
    """Tilezen joerd, docs/use-service.md; Registry of Open Data on AWS, “Copernicus DEM”."""
    tile = Tile(40, 14)
    assert SOURCES["srtm"].url(tile) == (
        "https://elevation-tiles-prod.s3.amazonaws.com/skadi/N40/N40E014.hgt.gz"
    )
    folder = "https://copernicus-dem-30m.s3.amazonaws.com/Copernicus_DSM_COG_10_N40_00_E014_00_DEM"
    assert (
        SOURCES["copernicus"].url(tile) == f"{folder}/Copernicus_DSM_COG_10_N40_00_E014_00_DEM.tif"
    )


def names(extent, most=100, source=None):
    return [tile.name for tile, _ in tiles_of(extent, source or SOURCES["srtm"], most)]


def test_an_extent_needs_every_tile_it_touches():
    assert names(Extent(14.3, 40.7, 14.5, 40.9)) == ["N40E014"]
    assert names(Extent(13.9, 40.9, 14.1, 41.1)) == ["N41E013", "N41E014", "N40E013", "N40E014"]
    # A whole tile does not need its neighbours, whose edges it shares.
    assert names(Extent(14, 40, 15, 41)) == ["N40E014"]
    # Nor does a point on an edge need both sides.
    assert names(Extent(14, 41, 14, 41)) == ["N40E013"]
    assert names(Extent(-0.5, -0.5, 0.5, 0.5)) == ["N00W001", "N00E000", "S01W001", "S01E000"]


def test_the_antimeridian_is_crossed_with_longitudes_that_go_on():
    places = tiles_of(Extent(179.5, -17.0, 180.5, -16.5), SOURCES["srtm"], 10)
    assert [(tile.name, west) for tile, west in places] == [("S17E179", 179), ("S17W180", 180)]
    assert names(Extent(-180.5, -17.0, -179.5, -16.5)) == ["S17E179", "S17W180"]


def test_a_margin_is_as_wide_in_every_direction():
    extent = widen(Extent(14.0, 60.0, 14.0, 60.0), 10_000)
    # Arcs on the sphere of the IUGG's mean radius.
    metres = math.radians(1) * 6_371_008.8
    assert (extent.north_deg - 60) * metres == pytest.approx(10_000)
    assert (60 - extent.south_deg) * metres == pytest.approx(10_000)
    at_north = math.cos(math.radians(extent.north_deg))
    assert (extent.east_deg - 14) * metres * at_north == pytest.approx(10_000)


@pytest.mark.parametrize(
    ("extent", "words"),
    [
        (Extent(10, 36, 19, 47), "needs 99 tiles of one degree, more than the 16 allowed"),
        (Extent(-179.5, -17, 179.5, -16), "needs 360 tiles .* such as 179.5 to 180.5"),
        (Extent(10, 59, 11, 61), "latitude 59° to 61°.*covers -56° to 60°; choose another SOURCE"),
        (Extent(-70, -57, -69, -55), "covers -56° to 60°"),
        (Extent(10, 89, 11, 91), "beyond the globe"),
        (Extent(400, 10, 401, 11), "beyond the globe"),
        (Extent(11, 10, 10, 11), "is none"),
        (Extent(math.nan, 10, 10, 11), "is none"),
        (Extent(10, 10, math.inf, 11), "is none"),
    ],
)
def test_extents_that_cannot_be_had_are_refused(extent, words):
    with pytest.raises(MuyscError, match=words):
        tiles_of(extent, SOURCES["srtm"], 16)


def test_a_template_tells_tiles_apart():
    source = source_of(" https://server/{longitude}/{latitude}.hgt ")
    assert source.url(Tile(-8, 110)) == "https://server/E110/S08.hgt"
    assert source_of("copernicus") is SOURCES["copernicus"]
    for text, words in (
        ("", "is no source"),
        ("ftp://server/{tile}.hgt", "is no source"),
        ("aster", "use srtm or copernicus"),
        ("https://server/{z}/{tile}.hgt", r"holds \{z\}"),
        ("https://server/{latitude}.hgt", "the same for each"),
    ):
        with pytest.raises(MuyscError, match=words):
            source_of(text)


def test_the_public_part_of_an_address_holds_no_secret():
    url = "https://user:word@server:8080/a/N40E014.hgt?key=abc#part"  # pragma: allowlist secret
    assert public_part(url) == "https://server:8080/a/N40E014.hgt"
    assert public_part("file:///data/N40E014.hgt") == "file:///data/N40E014.hgt"

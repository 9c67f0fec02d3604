"""Tiles of one degree: where they come from, what they are called, which an extent needs."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from urllib.parse import urlsplit

from ..errors import MuyscError

#: Mean radius of the Earth (m), IUGG; for the margin around an extent.
_EARTH_RADIUS_M = 6_371_008.8

#: What a URL template may hold, as the tile at 40° to 41° north and 14° to 15° east fills it in.
PLACEHOLDERS = {"{tile}": "N40E014", "{latitude}": "N40", "{longitude}": "E014"}

#: Bytes that a tile may have on its way: an uncompressed tile of 3601² heights with room
#: for headers; a GeoTIFF of 3600² heights in 4 bytes with its overviews.
_LARGEST_HGT_BYTES = 27_000_000
_LARGEST_TIFF_BYTES = 80_000_000


@dataclass(frozen=True)
class Extent:
    """A part of the globe in degrees; east may go past 180 where it crosses the antimeridian."""

    west_deg: float
    south_deg: float
    east_deg: float
    north_deg: float


@dataclass(frozen=True)
class Tile:
    """One degree by one, named after its south-western corner."""

    latitude_deg: int
    #: −180 to 179.
    longitude_deg: int

    @property
    def latitude(self) -> str:
        """Southern edge as in ``N40``."""
        return f"{'S' if self.latitude_deg < 0 else 'N'}{abs(self.latitude_deg):02d}"

    @property
    def longitude(self) -> str:
        """Western edge as in ``E014``."""
        return f"{'W' if self.longitude_deg < 0 else 'E'}{abs(self.longitude_deg):03d}"

    @property
    def name(self) -> str:
        """Name as in ``N40E014``."""
        return self.latitude + self.longitude


@dataclass(frozen=True)
class Source:
    """Where tiles come from, and what users must know about them."""

    title: str
    #: Address of a tile, with `PLACEHOLDERS`.
    template: str
    south_deg: float
    north_deg: float
    #: What heights are measured from.
    height_datum: str
    attribution: str

    @property
    def largest_bytes(self) -> int:
        """Bytes that a tile may have on its way."""
        path = self.template.partition("?")[0].lower()
        return _LARGEST_TIFF_BYTES if path.endswith((".tif", ".tiff")) else _LARGEST_HGT_BYTES

    def url(self, tile: Tile) -> str:
        """Return the address of a tile."""
        address = self.template
        for placeholder, value in zip(PLACEHOLDERS, (tile.name, tile.latitude, tile.longitude)):
            address = address.replace(placeholder, value)
        return address


SOURCES = {
    # The tiles and their address: Tilezen joerd, docs/formats.md and docs/use-service.md;
    # Registry of Open Data on AWS, “Terrain Tiles”. Latitudes: NASA SRTM, 60° N to 56° S.
    # Attribution: joerd, docs/attribution.md.
    "srtm": Source(
        "Terrain Tiles: SRTM, one arc second",
        "https://elevation-tiles-prod.s3.amazonaws.com/skadi/{latitude}/{tile}.hgt.gz",
        -56.0, 60.0, "EGM96 geoid (EPSG:5773)",
        "SRTM data courtesy of the U.S. Geological Survey; bathymetry courtesy of the U.S. "
        "National Oceanic and Atmospheric Administration; Terrain Tiles by Mapzen",
    ),
    # Address: Registry of Open Data on AWS, “Copernicus DEM”. Attribution: licence for
    # Copernicus WorldDEM-30, the text for data that were adapted or modified.
    "copernicus": Source(
        "Copernicus DEM GLO-30, one arc second",
        "https://copernicus-dem-30m.s3.amazonaws.com/"
        "Copernicus_DSM_COG_10_{latitude}_00_{longitude}_00_DEM/"
        "Copernicus_DSM_COG_10_{latitude}_00_{longitude}_00_DEM.tif",
        -90.0, 84.0, "EGM2008 geoid (EPSG:3855)",
        "produced using Copernicus WorldDEM-30 © DLR e.V. 2010-2014 and © Airbus Defence and "
        "Space GmbH 2014-2018 provided under COPERNICUS by the European Union and ESA; all "
        "rights reserved",
    ),
}  # fmt: skip


def source_of(text: str) -> Source:
    """Return a source by its word in `SOURCES` or by a URL template.

    Raises
    ------
    MuyscError
        If the text is neither, or its addresses would not tell tiles apart.
    """
    text = text.strip()
    if text in SOURCES:
        return SOURCES[text]
    if not re.match(r"(https?|file)://", text):
        raise MuyscError(
            f"“{text}” is no source of tiles; use {' or '.join(SOURCES)}, or an address that "
            "begins with https:// or file:// and holds {tile}."
        )
    unknown = set(re.findall(r"\{[^}]*\}", text)) - set(PLACEHOLDERS)
    if unknown:
        raise MuyscError(
            f"The address of tiles holds {', '.join(sorted(unknown))}; use "
            f"{', '.join(PLACEHOLDERS)}, which stand for such as "
            f"{', '.join(PLACEHOLDERS.values())}."
        )
    if "{tile}" not in text and not ("{latitude}" in text and "{longitude}" in text):
        raise MuyscError(
            "The address of tiles is the same for each; it must hold {tile}, or {latitude} and "
            "{longitude}."
        )
    return Source("Tiles of your own source", text, -90.0, 90.0, "as its source says", "")


def public_part(url: str) -> str:
    """Return an address for messages and files: without user, password, key and fragment."""
    parts = urlsplit(url)
    return f"{parts.scheme}://{parts.netloc.rpartition('@')[2]}{parts.path}"


def widen(extent: Extent, margin_m: float) -> Extent:
    """Return an extent with a margin (m) around it."""
    margin_deg = math.degrees(margin_m / _EARTH_RADIUS_M)
    furthest_deg = min(max(abs(extent.south_deg), abs(extent.north_deg)) + margin_deg, 89.0)
    sideways_deg = margin_deg / math.cos(math.radians(furthest_deg))
    return Extent(
        extent.west_deg - sideways_deg,
        extent.south_deg - margin_deg,
        extent.east_deg + sideways_deg,
        extent.north_deg + margin_deg,
    )


def tiles_of(extent: Extent, source: Source, most: int) -> list[tuple[Tile, int]]:
    """Return the tiles that an extent needs, from the north-west on.

    Parameters
    ----------
    extent
        Part of the globe.
    source
        Where tiles come from; it tells the latitudes that there are.
    most
        Number of tiles that is still accepted.

    Returns
    -------
    list
        Tiles, each with its western edge in the extent's own longitudes, which past 180°
        differ from the tile's.

    Raises
    ------
    MuyscError
        If the extent is nowhere on Earth, beyond the source's latitudes, or too large.
    """
    _check(extent, source)
    south, north = math.floor(extent.south_deg), math.ceil(extent.north_deg)
    west, east = math.floor(extent.west_deg), math.ceil(extent.east_deg)
    south, west = min(south, north - 1), min(west, east - 1)
    count = (north - south) * (east - west)
    if count > most:
        raise MuyscError(
            f"The extent needs {count} tiles of one degree, more than the {most} allowed; choose "
            "a smaller extent or raise MAX_TILES. One across the antimeridian is written with "
            "longitudes that go on, such as 179.5 to 180.5."
        )
    return [
        (Tile(latitude, (longitude + 180) % 360 - 180), longitude)
        for latitude in reversed(range(south, north))
        for longitude in range(west, east)
    ]


def _check(extent: Extent, source: Source) -> None:
    edges = (extent.west_deg, extent.south_deg, extent.east_deg, extent.north_deg)
    west, south, east, north = edges
    if not all(map(math.isfinite, edges)) or west > east or south > north:
        raise MuyscError(
            f"The extent from {west:g}° to {east:g}° east and {south:g}° to {north:g}° north is "
            "none; give west, east, south and north with their coordinate reference system."
        )
    if west < -360 or east > 360 or south < -90 or north > 90:
        raise MuyscError(
            f"The extent reaches from {west:g}° to {east:g}° east and {south:g}° to {north:g}° "
            "north, beyond the globe; check its coordinate reference system and the margin."
        )
    if south < source.south_deg or north > source.north_deg:
        raise MuyscError(
            f"The extent reaches from latitude {south:g}° to {north:g}°, and {source.title} "
            f"covers {source.south_deg:g}° to {source.north_deg:g}°; choose another SOURCE, such "
            "as copernicus, or a smaller extent."
        )

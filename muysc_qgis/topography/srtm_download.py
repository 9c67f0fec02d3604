"""From an extent to its heights: tiles from the cache or the network, put together."""

from __future__ import annotations

from collections.abc import Callable

from ..errors import MuyscError
from ..progress import Progress, report, silent
from .srtm import Extent, Source, Tile, public_part, tiles_of
from .srtm_cache import TileCache
from .srtm_mosaic import Canvas, Mosaic
from .srtm_tiles import TileHeights, decode

#: Called with an address and the bytes that may come; returns what came, None where the
#: server says that there is nothing. Raises `MuyscError` or `Cancelled`.
Fetch = Callable[[str, int], "bytes | None"]

#: No dry land lies this low (m): the shore of the Dead Sea is near −430 m.
_SEA_FLOOR_M = -500.0

#: Names told in a message at most.
_NAMES_TOLD = 8


def download(
    extent: Extent,
    source: Source,
    most_tiles: int,
    cache: TileCache,
    fetch: Fetch,
    progress: Progress = silent,
) -> Mosaic:
    """Return the heights of an extent.

    Parameters
    ----------
    extent
        Part of the globe.
    source
        Where tiles come from.
    most_tiles
        Number of tiles that is still accepted.
    cache
        Where tiles are looked for first, and kept as soon as they are checked.
    fetch
        Gets what a cache does not have.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the extent cannot be used, a tile cannot be had or is none, or the source has
        no tile of the extent at all.
    Cancelled
        If it was asked to stop.
    """
    places = tiles_of(extent, source, most_tiles)
    canvas = Canvas(extent, places)
    sea: list[str] = []
    cached = 0
    for done, (tile, west_deg) in enumerate(places):
        report(progress, done / len(places))
        heights, was_cached = _heights_of(tile, source, cache, fetch)
        cached += was_cached
        if heights is None:
            sea.append(tile.name)
        else:
            canvas.put(tile, west_deg, heights)
    if len(sea) == len(places):
        raise MuyscError(
            f"{public_part(source.template)} has none of the tiles of the extent ({_listed(sea)}): "
            "it is open sea, or the address is wrong; choose another extent or SOURCE."
        )
    return Mosaic(canvas.grid, canvas.heights, len(places), cached, tuple(sea))


def notes_on(mosaic: Mosaic, source: Source) -> tuple[list[str], list[str]]:
    """Return what the log says about the heights, and what it warns of."""
    lowest, highest = mosaic.range_m
    notes = [
        f"{mosaic.tiles} tiles, {mosaic.cached_tiles} of them from the cache.",
        f"Heights from {lowest:.0f} to {highest:.0f} m; datum: {source.height_datum}.",
    ]
    if source.attribution:
        notes.append(f"Name the source wherever you show the heights: {source.attribution}.")
    warnings = []
    if mosaic.sea_tiles:
        warnings.append(
            f"The source has no tile {_listed(mosaic.sea_tiles)}; it was taken as sea level. "
            "Where there is land, its rock is missing."
        )
    if lowest == highest:
        warnings.append(
            f"All heights are {lowest:.0f} m, so there is no rock to look through; see that the "
            "extent is where it is meant to be."
        )
    if lowest < _SEA_FLOOR_M:
        warnings.append(
            f"The heights go down to {lowest:.0f} m: they are those of the sea floor, and the "
            "water above it does not count as rock."
        )
    if mosaic.filled_cells:
        notes.append(f"{mosaic.filled_cells} cells without a height were filled.")
    voids = mosaic.void_cells
    if voids:
        warnings.append(
            f"{voids} cells ({voids / mosaic.heights.size:.2%}) have no height; rays through them "
            "may stay unknown: fill voids, or choose another source."
        )
    return notes, warnings


def _heights_of(
    tile: Tile, source: Source, cache: TileCache, fetch: Fetch
) -> tuple[TileHeights | None, bool]:
    """Return a tile, None where the source has none, and whether it was in the cache."""
    url = source.url(tile)
    payload = cache.read(tile)
    if payload is not None:
        return decode(payload, tile, public_part(url)), True
    payload = fetch(url, source.largest_bytes)
    if payload is None:
        return None, False
    heights = decode(payload, tile, public_part(url))
    cache.write(tile, payload)
    return heights, False


def _listed(names: list[str] | tuple[str, ...]) -> str:
    more = len(names) - _NAMES_TOLD
    return ", ".join(names[:_NAMES_TOLD]) + (f" and {more} more" if more > 0 else "")

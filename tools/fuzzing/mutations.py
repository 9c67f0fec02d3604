"""Files with bytes changed, cut or doubled, and rasters that say absurd things of themselves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from hypothesis import strategies as st

#: Where in a file (0 to 1; headers are at its start) and what is done there.
_PLACE = st.one_of(st.floats(0, 0.02), st.floats(0, 1))
_EDIT = st.one_of(
    st.tuples(st.just("set"), _PLACE, st.integers(0, 255)),
    st.tuples(st.just("cut"), _PLACE, st.just(0)),
    st.tuples(st.just("drop"), _PLACE, st.integers(1, 64)),
    st.tuples(st.just("blank"), _PLACE, st.integers(1, 4096)),
    st.tuples(st.just("repeat"), _PLACE, st.integers(1, 256)),
)
edits = st.lists(_EDIT, min_size=1, max_size=6)

_ABSURD = st.one_of(
    st.sampled_from(
        ["", "nan", "inf", "-inf", "1e400", "-1", "0", "360.5", "1e300", "north", "<b>", "tangent",
         "counts", "density", "9" * 400, "é\u202e"]
    ),
    st.floats().map(repr),
    st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=12),
)  # fmt: skip
_KEYS = (
    "QUANTITY", "UNIT", "DETECTOR_LON", "DETECTOR_LAT", "DETECTOR_ELEVATION", "DENSITY",
    "BORESIGHT_AZIMUTH", "BORESIGHT_ELEVATION", "FLUX_MODEL", "ENERGY_LOSS", "ACCEPTANCE", "DAYS",
    "PROJECTION", "VERSION", "ROLL", "MATERIAL", "MERGE", "MAX_RANGE", "TARGET_DISTANCE",
)  # fmt: skip
_ENTRIES = st.dictionaries(st.sampled_from(_KEYS), st.one_of(st.none(), _ABSURD), max_size=3)
#: Entries of the metadata, None for removed; geotransform, no-data and values of a raster.
claims = st.fixed_dictionaries(
    {"metadata": _ENTRIES},
    optional={
        "geotransform": st.lists(
            st.one_of(st.sampled_from([0.0, 1.0, -1.0, 1e-9, 1e9, 89.0, 350.0]), st.floats()),
            min_size=6, max_size=6,
        ),
        "no_data": st.floats(),
        "value": st.floats(),
    },
)  # fmt: skip


def mutate(source: Path, target: Path, changes: list[tuple[str, float, int]]) -> None:
    """Write a file with its bytes changed."""
    content = bytearray(source.read_bytes())
    for kind, place, amount in changes:
        at = int(place * max(0, len(content) - 1))
        if kind == "set" and content:
            content[at] = amount
        elif kind == "cut":
            del content[at:]
        elif kind == "drop":
            del content[at : at + amount]
        elif kind == "blank":
            content[at : at + amount] = bytes(len(content[at : at + amount]))
        elif kind == "repeat":
            content[at:at] = content[at : at + amount] * 3
    target.write_bytes(content)


def misstate(source: Path, target: Path, claim: dict[str, Any]) -> None:
    """Write a raster that says other things of itself than it should."""
    from osgeo import gdal

    gdal.UseExceptions()
    target.write_bytes(source.read_bytes())
    dataset = gdal.Open(str(target), gdal.GA_Update)
    entries = {**dataset.GetMetadata("MUYSC"), **claim["metadata"]}
    dataset.SetMetadata({key: one for key, one in entries.items() if one is not None}, "MUYSC")
    if "geotransform" in claim:
        dataset.SetGeoTransform(claim["geotransform"])
    band = dataset.GetRasterBand(1)
    if "no_data" in claim:
        band.SetNoDataValue(claim["no_data"])
    if "value" in claim:
        values = band.ReadAsArray().astype(float)
        values[values.shape[0] // 2, values.shape[1] // 2 :] = claim["value"]
        band.WriteArray(values)
    del band, dataset

"""Units of height and the heights that exist."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import MuyscError

if TYPE_CHECKING:
    from pyproj import CRS

#: Metres per unit of height. International foot: 0.3048 m (1959 agreement);
#: US survey foot: 1200/3937 m (NIST SP 811, appendix B.6).
UNITS = {"metre": 1.0, "foot": 0.3048, "us_survey_foot": 1200 / 3937}

#: No surface on Earth lies higher: Chomolungma, 8849 m (2020 survey), and a
#: margin for ellipsoidal heights, which differ from it by less than 110 m.
PEAK_M = 9000.0
#: Nor lower: Challenger Deep, about 10 935 m below the sea (Greenaway et al.
#: 2021, doi:10.1016/j.dsr.2021.103644), with the same margin.
LOWEST_M = -11_100.0

#: The code for missing heights that many programs write without flagging it; as
#: a depth it would be met to the metre in a few trenches only.
UNFLAGGED_NO_DATA_M = -9999.0

#: Spellings in the unit tag of a raster band.
_SPELLINGS = {
    "m": "metre", "metre": "metre", "meter": "metre", "metres": "metre", "meters": "metre",
    "ft": "foot", "foot": "foot", "feet": "foot", "international foot": "foot",
    "us-ft": "us_survey_foot", "ftus": "us_survey_foot", "us_ft": "us_survey_foot",
    "us survey foot": "us_survey_foot", "us survey feet": "us_survey_foot",
    "foot_us": "us_survey_foot", "survey foot": "us_survey_foot",
}  # fmt: skip


def metres_per_unit(unit: str, tag: str, crs: CRS, name: str) -> tuple[float, str | None]:
    """Find the unit of a raster's heights.

    Parameters
    ----------
    unit
        Key of `UNITS`, or ``auto`` to find it in the file.
    tag
        Unit tag of the band, empty where there is none.
    crs
        CRS of the raster, whose vertical part is asked where the tag is empty.
    name
        File name, for messages.

    Returns
    -------
    tuple
        Metres per unit, and a sentence where something had to be assumed.

    Raises
    ------
    MuyscError
        If the unit is not one of heights.
    """
    if unit in UNITS:
        return UNITS[unit], None
    if unit != "auto":
        raise MuyscError(f"“{unit}” is not a unit of height; use auto, {', '.join(UNITS)}.")
    if tag.strip():
        spelling = _SPELLINGS.get(tag.strip().lower())
        if spelling is None:
            raise MuyscError(
                f"The heights of the DEM {name} are in “{tag}”, which is not a known unit of "
                f"height; set the height unit to {', '.join(UNITS)}."
            )
        return UNITS[spelling], None
    if len(crs.axis_info) == 3:
        return float(crs.axis_info[2].unit_conversion_factor), None
    horizontal = crs.axis_info[0].unit_name if crs.axis_info else ""
    if crs.is_projected and "foot" in horizontal.lower():
        return 1.0, (
            f"The DEM {name} does not say the unit of its heights; they were taken as metres "
            f"although its coordinates are in {horizontal}: set the height unit if they are feet."
        )
    return 1.0, None

"""Rasters of counts, as what stations counted and how much they collect."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..errors import MuyscError
from ..muogram import Muogram
from ..radiography.settings import Physics
from ..telescope.acceptance import FORMULAS, trajectories
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import merge_sum
from ..tomography.counting import COUNTS
from ..trajectories import TrajectoryMap
from ..views import metres_apart, require_quantity, require_same_directions
from .count_lines import CountStation
from .named_view import NamedView

#: Detectors of counts and of acceptances farther apart (m) than this are two.
_SAME_PLACE_M = 1.0

#: What makes a telescope, as `describe_telescope` writes it.
_TELESCOPE = ("BARS_X", "BARS_Y", "PIXEL_SIZE", "SEPARATION")


def read_count_stations(
    counts: Sequence[NamedView],
    acceptances: Sequence[NamedView] = (),
    physics: Physics | None = None,
) -> list[CountStation]:
    """Return what stations counted.

    Parameters
    ----------
    counts
        Rasters of counts, with the days, the place, and the telescope or the acceptance in their
        metadata.
    acceptances
        Rasters of acceptances (cm² sr) of some of them: on the same pixels.
    physics
        How muons are made and stopped; None for what the metadata say.

    Raises
    ------
    MuyscError
        If there is none, one holds something else, or what is needed is missing.
    """
    if not counts:
        raise MuyscError("No raster of counts is given; choose those of one station or more.")
    for one in counts:
        require_quantity(one.view, ("counts",), one.name)
    matched = _matched(counts, acceptances)
    return [_station(one, own, physics) for one, own in zip(counts, matched)]


def refuse_other_method(method: str, asked: bool, mask: bool) -> None:
    """Refuse to read counts by a method that cannot.

    Parameters
    ----------
    method
        Chosen, or the default.
    asked
        Whether it was chosen.
    mask
        Whether voxels of air are known.

    Raises
    ------
    MuyscError
        If it is not `COUNTS`, or air is unknown.
    """
    if asked and method not in (COUNTS, "bayes"):
        raise MuyscError(
            f"The muograms hold counts, which {method} cannot read: pixels without a muon say no "
            "opacity, and leaving them out would make thick rock look light; choose the method "
            "counts, or make densities of merged pixels with Density from a measured muogram."
        )
    if not mask:
        raise MuyscError(
            "Counts are fitted where the terrain is known, and TERRAIN_MASK is off; switch it on, "
            "or give muograms of density and another method."
        )


def _station(one: NamedView, acceptance: NamedView | None, physics: Physics | None) -> CountStation:
    view = one.view
    days = one.number("DAYS")
    efficiency = one.number("EFFICIENCY") if "EFFICIENCY" in view.metadata else 1.0
    if not days > 0 or not 0 < efficiency <= 1:
        raise MuyscError(
            f"{one.name} was counted for {days:g} days with an efficiency of {efficiency:g}; set "
            "DAYS above 0, and EFFICIENCY above 0 and up to 1."
        )
    place = (
        one.name, one.number("DETECTOR_LON"), one.number("DETECTOR_LAT"),
        one.number("DETECTOR_ELEVATION"),
    )  # fmt: skip
    target = None
    if {"TARGET_LON", "TARGET_LAT", "TARGET_ELEVATION"} <= set(view.metadata):
        target = (
            one.number("TARGET_LON"), one.number("TARGET_LAT"), one.number("TARGET_ELEVATION"),
        )  # fmt: skip
    near = one.number("NEAR_FIELD") if "NEAR_FIELD" in view.metadata else 0.0
    far = one.number("MAX_RANGE") if "MAX_RANGE" in view.metadata else None
    physics = physics or one.physics()
    collected = None if acceptance is None else np.asarray(acceptance.view.values, float)
    if isinstance(view, Muogram):
        if collected is None:
            collected = np.full(view.values.shape, one.number("ACCEPTANCE"))
        return CountStation(
            *place, view.values, collected * days * efficiency, physics,
            azimuth_deg=view.azimuth_deg, elevation_deg=view.elevation_deg, near_field_m=near,
            max_range_m=far, target=target,
        )  # fmt: skip
    if not isinstance(view, TrajectoryMap):
        raise MuyscError(f"{one.name} is neither a muogram nor a raster in telescope angles.")
    geometry = _geometry(one)
    formula = str(view.metadata.get("FORMULA", "exact"))
    if formula not in FORMULAS:
        raise MuyscError(
            f"The metadata key FORMULA of {one.name} is “{formula}”; set it to "
            f"{' or '.join(FORMULAS)}."
        )
    own = trajectories(geometry, formula)
    merge = int(one.number("MERGE")) if "MERGE" in view.metadata else 1
    by_geometry = merge_sum(own.acceptance_cm2_sr, merge)
    if view.values.shape != by_geometry.shape:
        rows, columns = by_geometry.shape
        raise MuyscError(
            f"{one.name} has {view.values.shape[1]} × {view.values.shape[0]} pixels, and its "
            f"telescope {columns} × {rows} trajectories; correct BARS_X, BARS_Y and MERGE."
        )
    if collected is None:
        collected = by_geometry
    return CountStation(
        *place, view.values, collected * days * efficiency, physics, own, view.pointing, merge,
        near_field_m=near, max_range_m=far, target=target,
    )  # fmt: skip


def _geometry(one: NamedView) -> TelescopeGeometry:
    bars_x, bars_y, size, separation = (one.number(key) for key in _TELESCOPE)
    planes = one.number("PLANES") if "PLANES" in one.view.metadata else 2.0
    return TelescopeGeometry(int(bars_x), int(bars_y), size, separation, int(planes))


def _matched(
    counts: Sequence[NamedView], acceptances: Sequence[NamedView]
) -> list[NamedView | None]:
    """Return the acceptance of each raster of counts, on the same pixels and of the same place."""
    result: list[NamedView | None] = [None] * len(counts)
    for acceptance in acceptances:
        require_quantity(acceptance.view, ("acceptance",), acceptance.name)
        fits = [
            number
            for number, one in enumerate(counts)
            if result[number] is None and _belong_together(one, acceptance)
        ]
        if not fits:
            raise MuyscError(
                f"The acceptances {acceptance.name} belong to none of the rasters of counts: none "
                "has its detector and pixels; leave them out or choose their counts too."
            )
        result[fits[0]] = acceptance
    return result


def _belong_together(one: NamedView, acceptance: NamedView) -> bool:
    apart = metres_apart(one.view, acceptance.view)
    # An acceptance that knows no place is that of every telescope of its kind.
    if apart >= _SAME_PLACE_M or one.view.values.shape != acceptance.view.values.shape:
        return False
    try:
        if np.isfinite(apart):
            require_same_directions(one.view, "counts", acceptance.view, "acceptances")
    except MuyscError:
        return False
    return True

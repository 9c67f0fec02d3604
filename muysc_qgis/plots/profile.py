"""Section along the boresight: terrain, rays and the rock that they cross."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from . import scales, style, ticks
from .frames import new_axes, whole
from .legend import draw_legend
from .rays import Ray, ray_height_m, rock_intervals, rock_label

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Vertical exaggerations that are used, the smallest that gives the height below.
_EXAGGERATIONS = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 8.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0)

#: Size of the picture on the page (inches).
_WIDTH_IN = 8.9
_LOWEST_IN = 2.2
_TALLEST_IN = 4.6
_LEFT_IN = 0.75
_BELOW_IN = 0.5
_LEGEND_ROW_IN = 0.21
_LEGEND_COLUMN_IN = 1.9

#: Look of the ray to the target, and of all others.
_MAIN = {"color": style.RAY, "linewidth": 1.4}
_OTHER = {"color": style.DETECTOR, "linewidth": 1.0, "linestyle": "--"}


def section_panel(
    distance_m: np.ndarray,
    ground_m: np.ndarray,
    detector_elevation_m: float,
    rays: Sequence[Ray],
    target_distance_m: float | None = None,
    azimuth_deg: float | None = None,
    title: str = "Section along the boresight",
    subtitle: str = "",
    range_m: tuple[float, float] = (0.0, np.inf),
) -> Figure:
    """Return the terrain along one azimuth with rays and the rock they cross.

    The section ends a little beyond the target and the last rock of the rays.

    Parameters
    ----------
    distance_m
        (n,) increasing horizontal distances from the detector.
    ground_m
        (n,) ground heights in the straight-ray frame (the curvature's drop
        taken off); NaN where unknown.
    detector_elevation_m
        Height at which the rays start.
    rays
        Rays to draw; the legend tells the rock that each crosses.
    target_distance_m
        Horizontal distance of the target, marked on the first main ray.
    azimuth_deg
        Azimuth of the section, for the axis.
    title, subtitle
        Title, and a line below it.
    range_m
        Horizontal distances between which rock counts.

    Raises
    ------
    MuyscError
        If matplotlib is missing or no two neighbouring heights are known.
    """
    distance_m, ground_m = np.asarray(distance_m, float), np.asarray(ground_m, float)
    if np.count_nonzero(np.isfinite(ground_m)) < 2:
        raise MuyscError(
            f"The section has {np.count_nonzero(np.isfinite(ground_m))} known heights where it "
            "needs 2; choose a DEM that covers the ground between detector and target."
        )
    near, far = range_m[0], min(range_m[1], float(distance_m[-1]))
    counted_m, counted_ground_m = _up_to(far, distance_m, ground_m)
    rock = [
        _from(
            near,
            rock_intervals(counted_m, counted_ground_m, detector_elevation_m, ray.elevation_deg),
        )
        for ray in rays
    ]
    end = _end_m(distance_m, rock, target_distance_m)
    # One point more, so that the ground reaches the frame.
    shown = slice(0, int(np.searchsorted(distance_m, end)) + 1)
    lowest, highest = _heights_m(
        distance_m[shown], ground_m[shown], detector_elevation_m, rays, target_distance_m
    )
    exaggeration, height = _exaggeration(end, highest - lowest)
    # The scale is a round number; what is left over becomes sky.
    highest = lowest + height * end / (_WIDTH_IN * exaggeration)

    title, lines = fill(title, 85), fill(subtitle, 135).splitlines()
    heading = style.heading_height_in(title, lines) + 0.1
    limits = [
        (f"{name}, {ticks.number_label(round(at))} m", at)
        for name, at in (("Near field ends", near), ("Maximum range", range_m[1]))
        if 0 < at < end
    ]
    # Rays have the second column for themselves.
    gaps = bool(np.any(np.isnan(ground_m[shown])))
    rows = max(2 + (target_distance_m is not None) + gaps + len(limits), len(rays))
    legend_height = _LEGEND_ROW_IN * (0.4 + rows)
    page = heading + height + _BELOW_IN + legend_height
    figure = style.new_figure(style.WIDTH_IN, page)
    style.add_heading(figure, title, lines)
    axes = new_axes(figure, (_LEFT_IN, _BELOW_IN + legend_height, _WIDTH_IN, height))
    axes.set_xlim(0.0, end)
    axes.set_ylim(lowest, highest)
    legend = _draw_ends(axes, detector_elevation_m, rays, target_distance_m)
    legend += _draw_ground(axes, distance_m[shown], ground_m[shown], lowest)
    for label, at in limits:
        line = axes.axvline(at, color=style.INK, linewidth=0.9, linestyle=":", zorder=3)
        legend.append((label, line))
    others = len(legend)
    for ray, intervals in zip(rays, rock):
        line = _draw_ray(axes, ray, intervals, detector_elevation_m, min(end, far))
        length = rock_label(counted_m, counted_ground_m, detector_elevation_m, ray, intervals)
        angle = f"{ray.elevation_deg:.1f}°".replace("-", "−")
        legend.append((f"Ray {ray.label}, {angle}: {length}", line))
    _label_axes(axes, end, lowest, highest, height, azimuth_deg, exaggeration)
    for column, part in enumerate((legend[:others], legend[others:])):
        left = _LEFT_IN + column * _LEGEND_COLUMN_IN
        draw_legend(figure, part, left, legend_height, rows, _LEGEND_ROW_IN)
    return figure


def _up_to(
    far_m: float, distance_m: np.ndarray, ground_m: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return a profile that ends at a distance."""
    inside = distance_m < far_m
    return (
        np.append(distance_m[inside], far_m),
        np.append(ground_m[inside], np.interp(far_m, distance_m, ground_m)),
    )


def _from(near_m: float, intervals: np.ndarray) -> np.ndarray:
    """Return the parts of (k, 2) intervals beyond a distance."""
    beyond = np.maximum(intervals, near_m)
    return beyond[beyond[:, 1] > beyond[:, 0]]


def _end_m(distance_m: np.ndarray, rock: list[np.ndarray], target_m: float | None) -> float:
    """Return where the section ends: beyond the target and the last rock."""
    last = max([0.0, target_m or 0.0, *(float(part[-1, 1]) for part in rock if len(part))])
    whole = float(distance_m[-1])
    return min(whole, 1.12 * last) if last > 0 else whole


def _heights_m(
    distance_m: np.ndarray,
    ground_m: np.ndarray,
    detector_elevation_m: float,
    rays: Sequence[Ray],
    target_m: float | None,
) -> tuple[float, float]:
    """Return the lowest and highest height to show: ground, detector and target."""
    heights = [*ground_m[np.isfinite(ground_m)], detector_elevation_m]
    main = next((ray for ray in rays if ray.main), None)
    if main is not None and target_m is not None:
        heights.append(_at(detector_elevation_m, main, target_m))
    low, high = float(min(heights)), float(max(heights))
    margin = max(0.06 * (high - low), 0.002 * float(distance_m[-1]), 1.0)
    return low - margin, high + 2 * margin


def _exaggeration(length_m: float, rise_m: float) -> tuple[float, float]:
    """Return a round vertical exaggeration and the height of the picture (inches)."""
    true_height = _WIDTH_IN * rise_m / length_m
    exaggeration = next((e for e in _EXAGGERATIONS if e * true_height >= _LOWEST_IN), 100.0)
    if exaggeration * true_height > _TALLEST_IN:
        # Steeper than the page is tall: squeezed, and said so on the axis.
        exaggeration = _TALLEST_IN / true_height
    return exaggeration, max(_LOWEST_IN, exaggeration * true_height)


def _at(detector_elevation_m: float, ray: Ray, distance_m: float) -> float:
    """Return the height of a ray at one horizontal distance (m)."""
    return float(ray_height_m(detector_elevation_m, ray.elevation_deg, np.array(distance_m)))


def _draw_ground(
    axes: Axes, distance_m: np.ndarray, ground_m: np.ndarray, lowest_m: float
) -> list[tuple[str, object]]:
    """Draw the terrain; return its legend entry."""
    from matplotlib.patches import Patch

    axes.set_facecolor(style.SKY)
    axes.fill_between(distance_m, ground_m, lowest_m, color=style.ROCK, linewidth=0, zorder=1)
    axes.plot(distance_m, ground_m, color=style.INK, linewidth=style.LINE_WIDTH, zorder=2)
    look = {"facecolor": style.ROCK, "edgecolor": style.INK, "linewidth": 0.6}
    legend: list[tuple[str, object]] = [("Rock", Patch(**look))]
    unknown = ~np.isfinite(ground_m)
    # The ground is as little known between a gap and its neighbours.
    unknown[1:] |= ~np.isfinite(ground_m[:-1])
    unknown[:-1] |= ~np.isfinite(ground_m[1:])
    if unknown.any():
        axes.fill_between(
            distance_m, 0, 1, where=unknown, transform=axes.get_xaxis_transform(),
            zorder=1, **style.UNKNOWN_LOOK,
        )  # fmt: skip
        legend.append(("No elevation known", Patch(**style.UNKNOWN_LOOK)))
    return legend


def _draw_ray(
    axes: Axes, ray: Ray, intervals: np.ndarray, detector_elevation_m: float, end_m: float
) -> object:
    """Draw a ray, its stretches in rock thick; return its line for the legend."""
    look = _MAIN if ray.main else _OTHER
    order = 4 if ray.main else 3
    stretch = np.array([0.0, end_m])
    (line,) = axes.plot(
        stretch,
        ray_height_m(detector_elevation_m, ray.elevation_deg, stretch),
        zorder=order,
        **look,
    )
    for interval in intervals:
        axes.plot(
            interval, ray_height_m(detector_elevation_m, ray.elevation_deg, interval),
            color=look["color"], linewidth=5.0 if ray.main else 3.0, alpha=0.75,
            solid_capstyle="butt", zorder=order,
        )  # fmt: skip
    return line


def _draw_ends(
    axes: Axes, detector_elevation_m: float, rays: Sequence[Ray], target_m: float | None
) -> list[tuple[str, object]]:
    """Mark detector and target; return their legend entries."""
    above = {"zorder": 6, "clip_on": False}
    (detector,) = axes.plot([0.0], [detector_elevation_m], **above, **style.DETECTOR_MARK)
    entries: list[tuple[str, object]] = [("Detector", detector)]
    main = next((ray for ray in rays if ray.main), None)
    if main is not None and target_m is not None:
        height = _at(detector_elevation_m, main, target_m)
        (target,) = axes.plot([target_m], [height], **above, **style.TARGET_MARK)
        entries.append(("Target", target))
    return entries


def _label_axes(
    axes: Axes,
    end_m: float,
    lowest_m: float,
    highest_m: float,
    height_in: float,
    azimuth_deg: float | None,
    exaggeration: float,
) -> None:
    """Give the axes round ticks, and labels with units and the exaggeration."""
    across = ticks.multiples(0.0, end_m, ticks.round_step(end_m, 10))
    up = ticks.multiples(
        lowest_m, highest_m, ticks.round_step(highest_m - lowest_m, max(3, int(height_in / 0.4)))
    )
    frame = whole(axes)
    along = "" if azimuth_deg is None else f" along azimuth {azimuth_deg % 360:.1f}°"
    stretch = (
        "no vertical exaggeration"
        if exaggeration == 1
        else f"vertical exaggeration × {exaggeration:.2g}"
    )
    scales.draw_scale(
        frame,
        "bottom",
        across,
        name=f"Horizontal distance from the detector{along} (m); {stretch}",
    )
    scales.draw_scale(frame, "left", up, name="Elevation (m)")

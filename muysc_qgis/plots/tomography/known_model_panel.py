"""Original, reconstruction and error of a known model: views as in the paper, and slices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...tomography.voxels import view
from ...volume import Volume
from ...workflows.tomography_result import Tomography
from ...workflows.view_errors import both_known, paper_errors
from .. import style
from ..frames import page_axes
from ..scales import draw_colour_bar_below
from . import volume_scales
from .cut_axes import fitted
from .cuts import Cut, view_cut
from .pictures import (
    ABOVE,
    BAR,
    BAR_HEIGHT,
    BELOW,
    HEADING,
    LEFT,
    VIEWS,
    Picture,
    draw_picture,
    middle_place,
    slices,
    write_heading,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

TITLE = "Reconstruction of a known model"

#: A picture at most, and the distance of their left edges (inches).
_ROOM, _PITCH = (2.75, 2.5), 3.0

#: Metres of a kilometre.
_KM = 1e3

#: What stands over the three columns.
_COLUMNS = ("Original T", "Reconstruction R", "ε = R − T")


def known_model_panel(tomography: Tomography, truth: Volume) -> Figure:
    """Draw the sums of original and reconstruction along three axes, and slices, with errors.

    Parameters
    ----------
    tomography
        What was reconstructed.
    truth
        Densities of the known model in the same voxels, NaN where there is no rock.

    Raises
    ------
    MuyscError
        If the models do not fit each other, or matplotlib is missing.
    """
    rows = [*_view_rows(tomography, truth), *_slice_rows(tomography, truth)]
    lines = [
        f"T: what was to be found, R: what {len(tomography.stations)} stations with "
        f"{tomography.rays} rays find of it, both of the voxels that rays cross.",
        "Top view: sum over its largest value; front and side: length in rock of "
        f"{tomography.reference_density:.3g} g/cm³ with the same mass.",
    ]
    head = style.heading_height_in(TITLE, lines) + 0.05
    page_in = head + sum(row.height for row in rows) + 0.1
    figure = style.new_figure(style.WIDTH_IN, page_in)
    style.add_heading(figure, TITLE, lines)
    axes = page_axes(figure)
    top = page_in - head
    for row in rows:
        _draw_row(axes, top, row)
        top -= row.height
    return figure


@dataclass(frozen=True)
class _Row:
    """Original, reconstruction and error."""

    heading: str
    unit: str
    pictures: Sequence[Picture]
    #: What white stands for in the first two; None where their scale begins at 0.
    middle: float | None = None

    @property
    def height(self) -> float:
        return HEADING + ABOVE + fitted(self.pictures[0].cut.size_m, _ROOM)[1] + BELOW + BAR


def _view_rows(tomography: Tomography, truth: Volume) -> list[_Row]:
    known, found = both_known(tomography, truth)
    unit = tomography.reference_density * _KM
    rows: list[_Row] = []
    for name, error in paper_errors(tomography, truth).items():
        sums = [view(tomography.grid, values, name) for values in (known, found)]
        # Where nothing was found there is nothing to scale.
        units = [float(np.nanmax(np.abs(one))) or 1.0 if name == "top" else unit for one in sums]
        word = "" if name == "top" else " km"
        cuts = [view_cut(truth, name, one / by) for one, by in zip(sums, units)]
        rock = np.isfinite(view(tomography.grid, tomography.coverage.values, name))
        told = f"mean |ε| {error.mean:.3f}{word}, σ {error.deviation:.3f}{word}"
        title, along = VIEWS[name]
        pictures = _three(cuts, cuts[0].with_values(error.difference), rock, told)
        rows.append(_Row(f"{title}, sum {along}", word.strip(), pictures))
    return rows


def _slice_rows(tomography: Tomography, truth: Volume) -> list[_Row]:
    place = middle_place(tomography)
    difference = tomography.density.with_values("density", tomography.density.values - truth.values)
    rows: list[_Row] = []
    volumes = (truth, tomography.density, difference)
    for level in zip(*(slices(one, tomography.coverage, place) for one in volumes)):
        size = np.abs(level[2].cut.values[np.isfinite(level[2].cut.values)])
        told = f"mean |ε| {size.mean():.3f}, σ {size.std():.3f} g/cm³" if size.size else ""
        cuts = [one.cut for one in level]
        pictures = _three(cuts[:2], cuts[2], level[0].rock, told)
        rows.append(_Row(level[0].title, "g/cm³", pictures, tomography.reference_density))
    return rows


def _three(cuts: Sequence[Cut], difference: Cut, rock: np.ndarray, remark: str) -> list[Picture]:
    """Return original, reconstruction and error with their titles."""
    return [
        Picture(title, cut, rock, told)
        for title, cut, told in zip(_COLUMNS, (*cuts, difference), ("", "", remark))
    ]


def _draw_row(axes: Axes, top: float, row: _Row) -> None:
    """Draw original and reconstruction on one scale, and their difference on its own."""
    write_heading(axes, top, row.heading)
    top -= HEADING + ABOVE
    pictures = row.pictures
    both = np.concatenate([one.cut.values.ravel() for one in pictures[:2]])
    apart = pictures[2].cut.values
    if row.middle is None:
        shared = volume_scales.lengths(both)
    else:
        shared = volume_scales.diverging(both, row.middle)
    errors = volume_scales.diverging(apart, 0.0, 1e-6)
    scales: Sequence[ScalarMappable] = (shared, shared, errors)
    frames = [
        draw_picture(axes, LEFT + column * _PITCH, top, one, _ROOM, scale, column == 0)
        for column, (one, scale) in enumerate(zip(pictures, scales))
    ]
    for column, values, scale, word in (
        (0, both, shared, "T and R"), (2, apart, errors, "ε"),
    ):  # fmt: skip
        name = f"{word} ({row.unit})" if row.unit else word
        draw_colour_bar_below(frames[column], values, scale, name, BELOW, BAR_HEIGHT)

"""Panel and report of a comparison of methods: what is drawn and told, in which order."""

from __future__ import annotations

from ...tomography.method_comparison import COMPARABLE, Comparison
from ..provenance import Provenance
from ..report import Citation, Report, ReportFigure, Row
from ..style import png_bytes
from .method_panel import TITLE, method_panel

__all__ = ["method_panel", "report"]

_PHANTOM = Citation(
    "Phantom: Shepp, L. A. & Logan, B. F. (1974). The Fourier reconstruction of a head section. "
    "IEEE Transactions on Nuclear Science, 21(3), 21–43, with the grey levels of Toft, P. (1996).",
    "https://doi.org/10.1109/TNS.1974.6499235",
)


def report(
    comparison: Comparison,
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a comparison tells.

    Parameters
    ----------
    comparison
        What was computed.
    provenance
        What it was computed from, and when.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    size = len(comparison.truth)
    told = Report(
        title=TITLE,
        subtitle=f"Shepp–Logan head of {size} × {size} pixels from {comparison.angles} parallel "
        "projections",
        figures=[
            ReportFigure(
                "The head, its reconstructions on one scale of greys, the error of each against "
                "its time, and how the projections were approached from one iteration to the next. "
                "Methods that know their misfit at the end alone have a mark without a line.",
                png_bytes(method_panel(comparison)),
                "Reconstructions of the head by every method",
                is_panel=True,
            )
        ],
        results=_results(comparison),
        warnings=comparison.warnings,
        citations=[_PHANTOM],
    )
    return provenance.added_to(told)


def _results(comparison: Comparison) -> list[Row]:
    best = comparison.best
    rows = [
        Row("Smallest relative error", round(best.relative_error, 4)),
        Row("Method of the smallest error", COMPARABLE[best.method]),
        Row("Relative error of one grey level", round(comparison.grey_error, 4)),
        Row("Time of the ray paths, once for all", round(comparison.matrix_seconds, 3), "s"),
    ]
    for one in comparison.results:
        title = COMPARABLE[one.method]
        rows.append(Row(f"{title}: relative error", round(one.relative_error, 4)))
        rows.append(Row(f"{title}: time", round(one.seconds, 4), "s"))
    return rows

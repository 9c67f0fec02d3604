"""The report: one HTML file with figures, tables, warnings and citations in it.

The file needs nothing else to be read: figures are embedded, there are no
scripts, and the only addresses are those of the works cited. The style sheet
keeps to what the oldest viewer among QGIS's understands.
"""

from __future__ import annotations

import struct
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Union

import numpy as np

from ..errors import MuyscError
from .ticks import power_of_ten

_TEMPLATES = Path(__file__).parent / "templates"

#: First bytes of every PNG file, and where its header keeps width and height
#: (Portable Network Graphics, third edition, W3C 2025, sections 5.2 and 11.2.1).
_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_PNG_SIZE = slice(16, 24)

#: Width that figures are shown at (pixels); viewers without style sheets for
#: images would else show them in full size.
_SHOWN_WIDTH = 960

#: What a cell of a table may hold.
Value = Union[str, int, float, bool, None]


@dataclass(frozen=True)
class Citation:
    """A work to cite, with the address to find it at."""

    text: str
    url: str = ""


#: Works that every use of the plugin cites.
MUYSC_PAPER = Citation(
    "Peña-Rodríguez, J., et al. (2024). MUYSC: An end-to-end muography simulation toolbox. "
    "Geophysical Journal International, 237(1), 540–556.",
    "https://arxiv.org/abs/2303.02627",
)


@dataclass(frozen=True)
class ReportFigure:
    """A PNG file's content with its caption; `alternative` is for who cannot see it."""

    caption: str
    png: bytes
    alternative: str = ""
    #: Whether this picture is the panel, which may be an output of its own.
    is_panel: bool = False


@dataclass(frozen=True)
class Row:
    """One line of a table: what, how much, of which unit."""

    label: str
    value: Value
    unit: str = ""


@dataclass(frozen=True)
class PixelCount:
    """How many pixels are of one kind, and why."""

    label: str
    count: int
    reason: str = ""


@dataclass(frozen=True)
class OutputFile:
    """A file that was written along with the report."""

    label: str
    name: str


@dataclass(frozen=True)
class Report:
    """Everything that a report tells.

    Parameters
    ----------
    title, subtitle
        Title, and a sentence below it.
    date
        When the results were made, as text.
    figures
        In the order shown.
    results, parameters
        Lines of the two tables. Numbers are shown with six digits, NaN as
        “unknown”; give text where more digits matter.
    pixels, pixel_total
        Kinds of pixels (they may overlap) and the number of all.
    warnings
        Whatever the user must know before using the results.
    outputs
        Files written along with the report.
    citations
        Works to cite besides the paper and the plugin, such as those of the
        flux model and of the energy-loss table.
    versions
        Version by software; that of “MUYSC for QGIS” is cited.
    language
        Of the texts, as in HTML.
    """

    title: str
    date: str = ""
    subtitle: str = ""
    figures: Sequence[ReportFigure] = ()
    results: Sequence[Row] = ()
    parameters: Sequence[Row] = ()
    pixels: Sequence[PixelCount] = ()
    pixel_total: int = 0
    warnings: Sequence[str] = ()
    outputs: Sequence[OutputFile] = ()
    citations: Sequence[Citation] = ()
    versions: Mapping[str, str] = field(default_factory=dict)
    language: str = "en"


def value_text(value: Value) -> str:
    """Return a cell's value as text: six digits, “unknown” for NaN, a dash for None."""
    if value is None:
        return "–"
    if isinstance(value, (bool, np.bool_)):
        return "yes" if value else "no"
    if isinstance(value, (int, np.integer)):
        return str(int(value)).replace("-", "−")
    if isinstance(value, (float, np.floating)):
        if np.isnan(value):
            return "unknown"
        # The sum takes the sign off a zero.
        return _six_digits(float(value) + 0.0) if np.isfinite(value) else "unlimited"
    return str(value)


def _six_digits(value: float) -> str:
    mantissa, _, exponent = f"{value:.6g}".partition("e")
    power = f"·{power_of_ten(int(exponent))}" if exponent else ""
    return mantissa.replace("-", "−") + power


def share_text(count: int, total: int) -> str:
    """Return a count as a percentage of the total, never rounded to 0 or 100 by mistake."""
    if total <= 0:
        return ""
    percent = 100.0 * count / total
    if 0 < percent < 0.1:
        return "< 0.1 %"
    if 99.9 < percent < 100:
        return "> 99.9 %"
    return f"{percent:.1f} %"


def png_size(png: bytes) -> tuple[int, int]:
    """Return width and height of a PNG file's content (pixels).

    Raises
    ------
    MuyscError
        If it is not a PNG file's content.
    """
    if not png.startswith(_PNG_SIGNATURE) or len(png) < _PNG_SIZE.stop:
        raise MuyscError("A figure of the report is not a PNG image; pass the bytes of a PNG file.")
    width, height = struct.unpack(">II", png[_PNG_SIZE])
    return int(width), int(height)


def report_html(report: Report) -> str:
    """Return the report as one self-contained HTML document.

    Raises
    ------
    MuyscError
        If jinja2 is missing or a figure is not a PNG image.
    """
    try:
        from jinja2 import Environment, FileSystemLoader, StrictUndefined
    except ImportError as error:
        raise MuyscError(
            "The report needs the Python package jinja2, which this QGIS lacks; install "
            "it with the OSGeo4W setup, the system's package manager or pip and run again."
        ) from error
    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["value"] = value_text
    figures = []
    for figure in report.figures:
        width, height = png_size(figure.png)
        shown = min(width, _SHOWN_WIDTH)
        figures.append(
            {
                "caption": figure.caption,
                "alternative": figure.alternative or figure.caption,
                "width": shown,
                "height": round(height * shown / width),
                "base64": b64encode(figure.png).decode("ascii"),
            }
        )
    version = report.versions.get("MUYSC for QGIS", "")
    plugin = Citation(f"MUYSC for QGIS{f', version {version}' if version else ''}.")
    return environment.get_template("report.html").render(
        report=report,
        figures=figures,
        pixels=[(pixel, share_text(pixel.count, report.pixel_total)) for pixel in report.pixels],
        citations=[MUYSC_PAPER, plugin, *report.citations],
    )


def write_report(path: str | Path, report: Report) -> None:
    """Write the report as one self-contained HTML file.

    Raises
    ------
    MuyscError
        If jinja2 is missing, a figure is not a PNG image, or the file cannot be
        written.
    """
    document = report_html(report)
    try:
        Path(path).write_text(document, encoding="utf-8")
    except OSError as error:
        raise MuyscError(
            f"The report {path} cannot be written ({error.strerror}); choose another "
            "folder or close the program that holds the file."
        ) from error

"""The HTML report: well formed, self-contained, escaped, complete."""

import re
import sys
from base64 import b64decode
from html.parser import HTMLParser

import numpy as np
import pytest

pytest.importorskip("jinja2")

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots.report import (
    Citation,
    OutputFile,
    PixelCount,
    Report,
    ReportFigure,
    Row,
    png_size,
    report_html,
    share_text,
    value_text,
    write_report,
)

#: A grey image of one pixel.
PNG = b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGOoBwAAgQCApFRDnwAAAABJRU5ErkJggg=="
)
EVIL = "<script>alert('x')</script> & \"quoted\" $5"

_VOID = {"meta", "img", "br", "hr", "link", "input"}


class Document(HTMLParser):
    """Collects the elements with their attributes and text; fails on bad nesting."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.open = [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        element = {"tag": tag, "text": "", **dict(attrs)}
        self.elements.append(element)
        if tag not in _VOID:
            self.open.append(element)

    def handle_endtag(self, tag):
        assert self.open.pop()["tag"] == tag

    def handle_data(self, data):
        for element in self.open:
            element["text"] += data

    def all(self, tag):
        return [element for element in self.elements if element["tag"] == tag]

    def texts(self, tag):
        return [element["text"].strip() for element in self.all(tag)]


@pytest.fixture
def report():
    return Report(
        title="Muon radiography",
        subtitle="Casina Amelia to the Gran Cono",
        date="22 November 2025",
        figures=[ReportFigure("The panel", PNG, "Two pictures"), ReportFigure("The map", PNG)],
        results=[Row("Largest thickness", 1450.25, "m"), Row("Density", float("nan"), "g/cm³")],
        parameters=[Row("Straggling", True), Row("Azimuth aperture", 42.0, "°")],
        pixels=[
            PixelCount("Rock", 6000),
            PixelCount("Unknown", 3, "The ray reaches the edge of the DEM inside rock"),
        ],
        pixel_total=10_000,
        warnings=["The CRS was assumed.", "3 pixels are unknown."],
        outputs=[OutputFile("Thickness", "thickness.tif")],
        citations=[
            Citation("The flux model (2006).", "https://doi.org/10.1103/PhysRevD.74.053007")
        ],
        versions={"MUYSC for QGIS": "0.1.0", "numpy": "1.24"},
    )


def test_the_document_is_well_formed_html5(report):
    text = report_html(report)
    document = Document(text)
    assert text.startswith("<!DOCTYPE html>")
    (root,) = document.all("html")
    assert root["lang"] == "en"
    assert document.texts("title") == ["Muon radiography"]
    assert document.texts("h1") == ["Muon radiography"]
    names = [element["id"] for element in document.elements if "id" in element]
    assert len(names) == len(set(names))


def test_figures_are_embedded_with_captions_and_alternatives(report):
    document = Document(report_html(report))
    images = document.all("img")
    assert [image["alt"] for image in images] == ["Two pictures", "The map"]
    for image in images:
        kind, content = image["src"].split(",")
        assert kind == "data:image/png;base64"
        assert b64decode(content, validate=True) == PNG
    assert document.texts("figcaption") == ["Figure 1. The panel", "Figure 2. The map"]


def test_nothing_is_loaded_from_elsewhere(report):
    text = report_html(report)
    document = Document(text)
    assert not {"script", "link", "iframe", "object"} & {e["tag"] for e in document.elements}
    assert "@import" not in text
    assert "url(" not in text
    for element in document.elements:
        assert element.get("src", "data:").startswith("data:")
        assert "href" not in element or element["tag"] == "a"
    assert len(document.all("a")) == 2


def test_tables_tell_values_units_counts_and_shares(report):
    document = Document(report_html(report))
    cells = document.texts("td")
    for cell in (
        "1450.25",
        "m",
        "unknown",
        "yes",
        "42",
        "°",
        "6000",
        "60.0 %",
        "3",
        "< 0.1 %",
        "10000",
    ):
        assert cell in cells
    assert "The ray reaches the edge of the DEM inside rock" in cells
    assert "thickness.tif" in cells
    assert all(header["scope"] in ("row", "col") for header in document.all("th"))


def test_each_warning_is_listed(report):
    items = Document(report_html(report)).texts("li")
    assert items[:2] == list(report.warnings)


def test_what_to_cite_is_named(report):
    text = " ".join(Document(report_html(report)).texts("li"))
    for part in (
        "Peña-Rodríguez",
        "Geophysical Journal International",
        "MUYSC for QGIS, version 0.1.0",
        "The flux model (2006).",
    ):
        assert part in text


def test_every_string_is_escaped():
    document = Document(
        report_html(
            Report(
                title=EVIL, date=EVIL, subtitle=EVIL, language=EVIL, warnings=[EVIL],
                figures=[ReportFigure(EVIL, PNG, EVIL)],
                results=[Row(EVIL, EVIL, EVIL)], parameters=[Row(EVIL, EVIL, EVIL)],
                pixels=[PixelCount(EVIL, 1, EVIL)], outputs=[OutputFile(EVIL, EVIL)],
                citations=[Citation(EVIL, EVIL)], versions={EVIL: EVIL, "MUYSC for QGIS": EVIL},
            )
        )
    )  # fmt: skip
    assert document.all("script") == []
    assert document.texts("title") == [EVIL]
    assert document.all("img")[0]["alt"] == EVIL
    assert document.all("html")[0]["lang"] == EVIL
    # Each field once, the title in h1 too, and nothing lost.
    shown = sum(e["text"].count(EVIL) for e in document.all("body"))
    assert shown == 3 + 1 + 1 + 3 + 3 + 2 + 2 + 2 + 3 + 1


def test_empty_parts_leave_no_headings():
    document = Document(report_html(Report(title="Empty", date="today")))
    assert document.texts("h2") == ["How to cite"]
    assert document.all("table") == []
    one = Document(report_html(Report(title="One", date="today", warnings=["Careful."])))
    assert one.texts("h2")[0] == "Warning"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "–"), (True, "yes"), (np.bool_(False), "no"), (-3, "−3"), (np.int64(7), "7"),
        (0.1 + 0.2, "0.3"), (np.float32(2.5), "2.5"), (float("nan"), "unknown"), (-0.0, "0"),
        (float("inf"), "unlimited"), (1234567.0, "1.23457·10⁶"), (-3.2e-7, "−3.2·10⁻⁷"),
        ("as it is", "as it is"),
    ],
)  # fmt: skip
def test_values_as_text(value, text):
    assert value_text(value) == text


@pytest.mark.parametrize(
    ("count", "total", "text"),
    [
        (0, 10, "0.0 %"),
        (1, 10_000, "< 0.1 %"),
        (9999, 10_000, "> 99.9 %"),
        (10, 10, "100.0 %"),
        (1, 0, ""),
    ],
)
def test_shares_never_hide_a_few_pixels(count, total, text):
    assert share_text(count, total) == text


def test_large_figures_keep_their_proportions():
    header = PNG[:16] + (1500).to_bytes(4, "big") + (750).to_bytes(4, "big") + PNG[24:]
    assert png_size(header) == (1500, 750)
    (image,) = Document(report_html(Report("T", "today", figures=[ReportFigure("F", header)]))).all(
        "img"
    )
    assert int(image["width"]) == 2 * int(image["height"])


def test_what_is_no_png_is_refused():
    for content in (b"", b"GIF89a", PNG[:20]):
        with pytest.raises(MuyscError, match="not a PNG"):
            report_html(Report("T", "today", figures=[ReportFigure("F", content)]))


def test_the_file_is_utf_8_and_a_bad_path_is_said(report, tmp_path):
    path = tmp_path / "informe de España.html"
    write_report(path, report)
    text = path.read_text(encoding="utf-8")
    assert text == report_html(report)
    assert re.search(r'<meta charset="utf-8">', text)
    with pytest.raises(MuyscError, match="cannot be written"):
        write_report(tmp_path / "missing" / "report.html", report)


def test_without_jinja2_the_error_says_what_to_install(report, monkeypatch):
    monkeypatch.setitem(sys.modules, "jinja2", None)
    with pytest.raises(MuyscError, match=r"jinja2.*install"):
        report_html(report)

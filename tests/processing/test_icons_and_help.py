"""Every algorithm has an icon that can be drawn, and a page of help that is there."""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
ICONS = sorted([ROOT / "icon.svg", *(ROOT / "icons").rglob("*.svg")])


@pytest.mark.parametrize("size", [16, 24])
def test_every_icon_draws_something(qgis_application, size):
    from qgis.PyQt.QtGui import QImage, QPainter
    from qgis.PyQt.QtSvg import QSvgRenderer

    for path in ICONS:
        renderer = QSvgRenderer(str(path))
        assert renderer.isValid(), path.name
        image = QImage(size, size, QImage.Format.Format_ARGB32)
        image.fill(0)
        painter = QPainter(image)
        renderer.render(painter)
        painter.end()
        drawn = sum(image.pixelColor(x, y).alpha() > 0 for x in range(size) for y in range(size))
        # Neither empty nor a block.
        assert 0.1 < drawn / size**2 < 0.95, path.name


def test_every_algorithm_shows_the_icon_of_its_group(provider):
    for algorithm in provider.algorithms():
        group = algorithm.groupId().lower()
        assert (ROOT / "icons" / "groups" / f"{group}.svg").is_file(), algorithm.id()
        assert not algorithm.icon().pixmap(24, 24).isNull()


def test_every_parameter_says_what_it_is(provider):
    for algorithm in provider.algorithms():
        for one in algorithm.parameterDefinitions():
            # Outputs of a model are those of its steps.
            told = one.help() or (one.isDestination() and algorithm.groupId() == "models")
            assert told, f"{one.name()} of {algorithm.id()}"


def test_help_opens_a_page_that_is_there(provider):
    from qgis.PyQt.QtCore import QUrl

    for algorithm in provider.algorithms():
        page = Path(QUrl(algorithm.helpUrl()).toLocalFile())
        assert page.is_file(), algorithm.id()
        assert f"<code>{algorithm.id()}</code>" in page.read_text(encoding="utf-8")

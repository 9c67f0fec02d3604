"""What panels are made of: colours of pixels, places of labels, errors, libraries."""

import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.colors import to_hex

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots import style
from muysc_qgis.plots.colours import colour_scale, pixel_colours, sky_mask
from muysc_qgis.plots.contours import label_places
from muysc_qgis.plots.panel import muogram_panels, summary_panel
from muysc_qgis.plots.style import save_png
from muysc_qgis.quantities import COLOUR_STOPS, QUANTITIES

pytestmark = pytest.mark.filterwarnings("error")


def test_sky_unknown_and_zero_pixels_have_their_own_look():
    quantity = QUANTITIES["thickness"]
    values = np.array([[0.0, np.nan, 10.0, 1000.0]])
    scale = colour_scale(values, quantity)
    picture = pixel_colours(values, quantity, sky_mask(values, quantity), scale)[0] / 255
    assert to_hex(picture[0]) == style.SKY
    assert picture[1, 3] == 0
    assert to_hex(picture[2]) == COLOUR_STOPS["viridis"][0]
    assert to_hex(picture[3]) == COLOUR_STOPS["viridis"][-1]
    counts = QUANTITIES["counts"]
    picture = pixel_colours(values, counts, None, colour_scale(values, counts))[0] / 255
    assert to_hex(picture[0]) == COLOUR_STOPS["magma"][0]


def test_flux_of_the_open_sky_keeps_its_colour(mountain):
    flux = mountain["flux"]
    sky = sky_mask(mountain["thickness"].values, mountain["thickness"].kind)
    picture = pixel_colours(flux.values, flux.kind, sky, colour_scale(flux.values, flux.kind))
    assert to_hex(picture[0, 0] / 255) == COLOUR_STOPS["magma"][-1]


def test_a_png_that_cannot_be_written_is_said(mountain, tmp_path):
    figure = muogram_panels([mountain["flux"]])
    with pytest.raises(MuyscError, match="cannot be written"):
        save_png(figure, tmp_path / "missing" / "panel.png")


def test_no_muogram_is_an_error():
    with pytest.raises(MuyscError, match="at least one muogram"):
        muogram_panels([])
    with pytest.raises(MuyscError, match="at least one muogram"):
        summary_panel({})


def test_without_matplotlib_the_error_says_what_to_install(mountain, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.backends.backend_agg", None)
    with pytest.raises(MuyscError, match=r"matplotlib.*install"):
        muogram_panels([mountain["flux"]])


def test_pyplot_is_never_loaded(data_folder):
    code = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import numpy as np\n"
        "from muysc_qgis.muogram import Muogram\n"
        "from muysc_qgis.plots.panel import muogram_panels\n"
        "from muysc_qgis.plots.style import png_bytes\n"
        "values, angles = np.arange(25.0).reshape(5, 5), np.arange(5.0)\n"
        "png_bytes(muogram_panels([Muogram('thickness', values, angles, -angles)]))\n"
        "sys.exit('matplotlib.pyplot' in sys.modules)\n"
    )
    root = str(data_folder.parent.parent)
    run = subprocess.run([sys.executable, "-c", code, root], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_labels_stand_on_their_line_away_from_everything_else():
    x = np.linspace(0.0, 10.0, 101)
    upper = np.column_stack([x, np.full_like(x, 1.0)])
    lower = np.column_stack([x, np.where(x < 5, 0.9, 0.0)])
    wall = np.array([[9.0, 1.0], [9.0, 0.0]])
    none = np.empty((0, 2))
    first, second = label_places([[upper], [lower]], [wall], none)
    assert first[1] == 1.0
    assert 5.0 < first[0] < 9.0
    assert second[1] == 0.0
    ((x_marked, _),) = label_places([[upper]], [], np.array([[2.0, 1.0]]))
    assert x_marked > 5.0
    short = upper[:5]
    assert label_places([[short], []], [], none) == []
    assert label_places([[upper]], [upper + np.array([0.0, 0.05])], none) == []

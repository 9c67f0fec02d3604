"""Figures and reports of tomographies, from a volume whose values are known."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.text import Text

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots.provenance import Provenance
from muysc_qgis.plots.report import Row, report_html
from muysc_qgis.plots.style import png_bytes
from muysc_qgis.plots.tomography import cuts, documents, volume_scales
from muysc_qgis.plots.tomography.convergence import convergence_figure
from muysc_qgis.plots.tomography.cut_axes import UNSEEN, cell_colours
from muysc_qgis.plots.tomography.known_model_panel import known_model_panel
from muysc_qgis.plots.tomography.pictures import middle_place
from muysc_qgis.plots.tomography.section_picture import section_figure
from muysc_qgis.plots.tomography.slice_map import map_bounds
from muysc_qgis.plots.tomography.tomography_panel import tomography_panel
from muysc_qgis.tomography.solvers import Reconstruction
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.topography.relief import Relief
from muysc_qgis.volume import Volume
from muysc_qgis.workflows.reconstruction_test import BodyFound, KnownModelResult
from muysc_qgis.workflows.tomography_result import Place, StationResidual, Tomography
from muysc_qgis.workflows.view_errors import paper_errors

#: 6 × 5 × 4 voxels of 100 × 100 × 50 m.
GRID = VoxelGrid((451_000.0, 4_518_000.0, 800.0), (100.0, 100.0, 50.0), (6, 5, 4))
REFERENCE = 2.4


def make(grid=GRID, target=(451_250.0, 4_518_250.0, 870.0), stations=3, known_errors=True):
    """A volume with air in the upper corner of the east, and one voxel that no ray crosses."""
    east, north, up = np.indices(grid.shape)
    values = REFERENCE + 0.1 * (east - 2) + 0.01 * north + 0.001 * up
    rays = 1.0 + east + 2 * north
    air = (east + up) > grid.shape[0] + grid.shape[2] - 4
    rays[air] = values[air] = np.nan
    if min(grid.shape[:2]) > 1:
        rays[1, 1, 0], values[1, 1, 0] = 0.0, np.nan
    density = Volume("density", grid, values, "")
    residuals = tuple(
        StationResidual(f"S{n}$", 10, 1.0, 5.0, 0.1 * n, 1.0 + n if known_errors else np.nan)
        for n in range(1, stations + 1)
    )
    low = grid.origin_m
    places = tuple(
        Place(f"S{n}$", low[0] - 50 * n, low[1] + 80 * n, 700.0) for n in range(1, stations + 1)
    )
    return Tomography(
        density, density.with_values("coverage", rays), None,
        Reconstruction(values[np.isfinite(values)], 4, "discrepancy", np.array([9, 4, 2, 1.5, 1])),
        "sirt", REFERENCE, places, None if target is None else Place("target", *target),
        residuals, 0.05, 10 * stations, 2.0 if known_errors else np.nan,
        int(np.isfinite(rays).sum()), 1, {"the ray sees no rock": 7}, ("One <sentence>.",),
    )  # fmt: skip


@pytest.fixture
def tomography():
    return make()


@pytest.fixture
def slope():
    """Terrain that rises 0.1 m per m to the east and 0.05 m per m to the north."""
    east = 450_000.0 + 10 * np.arange(260)
    north = 4_517_000.0 + 10 * np.arange(260)
    return Relief(east, north, plane(east[None, :], north[:, None]))


def plane(east, north):
    return 850.0 + 0.1 * (east - 451_300.0) + 0.05 * (north - 4_518_250.0)


# Cuts.


def test_slices_are_the_voxels_at_a_place(tomography):
    density = tomography.density
    level = cuts.slice_at(density, 2, 849.0)
    assert np.array_equal(level.values, density.values[:, :, 0], equal_nan=True)
    assert level.limits_m == (451_000, 451_600, 4_518_000, 4_518_500)
    assert not level.is_vertical
    section = cuts.slice_at(density, 1, 4_518_250.0)
    assert np.array_equal(section.values, density.values[:, 2, :], equal_nan=True)
    assert section.limits_m == (451_000, 451_600, 800, 1000)
    assert section.is_vertical
    # Beyond the volume it is the outermost slice.
    beyond = cuts.slice_at(density, 0, 460_000.0)
    assert np.array_equal(beyond.values, density.values[5], equal_nan=True)
    assert (beyond.across, beyond.up) == ("Northing", "Elevation")


@pytest.mark.parametrize(("name", "axis"), [("top", 2), ("front", 1), ("side", 0)])
def test_views_are_means_of_what_is_known(tomography, name, axis):
    values = tomography.density.values
    found = cuts.mean_view(tomography.density, name).values
    known = np.isfinite(values).any(axis=axis)
    assert np.array_equal(np.isfinite(found), known)
    with np.errstate(invalid="ignore"):
        expected = np.nansum(values, axis=axis) / np.isfinite(values).sum(axis=axis)
    assert found[known] == pytest.approx(expected[known])


def test_a_line_along_voxels_is_their_slice(tomography):
    cut = cuts.along_line(tomography.density, [(451_000, 4_518_150), (451_600, 4_518_150)])
    expected = np.repeat(tomography.density.values[:, 1, :], 2, axis=0)
    assert np.array_equal(cut.values, expected, equal_nan=True)
    assert cut.limits_m == pytest.approx((0, 600, 800, 1000))


def test_a_line_round_a_corner_runs_on_and_knows_nothing_beyond_the_volume(tomography):
    points = [(450_800, 4_518_050), (451_050, 4_518_050), (451_050, 4_518_450)]
    cut = cuts.along_line(tomography.density, points)
    assert cut.size_m[0] == pytest.approx(650)
    assert np.isnan(cut.values[:4]).all()
    assert cut.values[-1, 0] == tomography.density.values[0, 4, 0]
    with pytest.raises(MuyscError, match="has 1 points and no length"):
        cuts.along_line(tomography.density, points[:1])


def test_heights_of_a_plane_are_exact_and_unknown_beyond_it(slope):
    east = np.array([450_003.0, 451_234.5, 452_500.0])
    north = np.array([4_517_777.0, 4_518_001.0, 4_519_000.0])
    found = cuts.heights_along(slope, east, north)
    assert found[:2] == pytest.approx(plane(east, north)[:2])
    assert np.isnan(cuts.heights_along(slope, np.array([440_000.0]), north[:1]))[0]


def test_cells_stand_upright_with_air_and_unseen_rock_apart(tomography):
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    scale = ScalarMappable(Normalize(2.0, 2.8), "gray")
    cut = cuts.slice_at(tomography.density, 1, 4_518_150.0)
    rock = np.isfinite(cuts.slice_at(tomography.coverage, 1, 4_518_150.0).values)
    picture = cell_colours(cut, scale, rock)
    assert picture.shape == (4, 6, 4)
    # The row at the top is the highest; (1, 1, 0) is rock that no ray crosses.
    assert picture[-1, 1, :3].tolist() == [int(UNSEEN[i : i + 2], 16) for i in (1, 3, 5)]
    assert picture[0, 5, 3] == 255  # sky
    value = tomography.density.values[0, 1, 3]
    assert picture[0, 0, 0] == pytest.approx(255 * (value - 2.0) / 0.8, abs=2)
    level = cuts.slice_at(tomography.density, 2, 990.0)
    assert cell_colours(level, scale, None)[0, 5, 3] == 0  # the map shows through


# Scales and places.


@pytest.mark.parametrize("values", [np.array([2.4, 2.1, np.nan]), np.full(3, 2.4), np.array([])])
def test_a_diverging_scale_has_its_middle_in_the_middle(values):
    low, high = volume_scales.diverging(values, 2.4).get_clim()
    assert (low + high) / 2 == pytest.approx(2.4)
    assert high - low > 0.019
    if np.isfinite(values).any():
        assert high - 2.4 >= 0.98 * np.nanmax(np.abs(values - 2.4))


def test_slices_run_through_the_target_or_the_middle(tomography):
    assert middle_place(tomography) == tomography.target
    middle = middle_place(replace(tomography, target=None))
    assert (middle.x, middle.y) == (451_300, 4_518_250)
    beyond = middle_place(make(target=(450_000.0, 4_518_250.0, 2000.0)))
    assert (beyond.x, beyond.y) == (451_050, 4_518_250)
    assert 800 < beyond.z < 1000


def test_the_map_holds_the_volume_and_the_stations_near_it(tomography):
    west, east, south, north = map_bounds(tomography)
    assert west < 450_850
    assert east > 451_600
    assert south < 4_518_000
    assert north > 4_518_500
    far = Place("far", 500_000.0, 4_518_000.0, 0.0)
    assert map_bounds(replace(tomography, stations=(*tomography.stations, far))) == (
        west, east, south, north,
    )  # fmt: skip
    alone = map_bounds(replace(tomography, stations=(far,)))
    assert alone[0] == pytest.approx(451_000 - 0.06 * 600)


# Figures.


def in_the_page(figure):
    """Whether every text ends within the page."""
    figure.draw_without_rendering()
    width, height = figure.canvas.get_width_height()
    for text in figure.findobj(Text):
        if not text.get_text() or not text.get_visible():
            continue
        box = text.get_window_extent()
        if not (box.x0 > -1 and box.x1 < width + 1 and box.y0 > -1 and box.y1 < height + 1):
            return text.get_text()
    return True


def texts(figure):
    return [one.get_text() for one in figure.findobj(Text)]


def test_the_panel_shows_slice_sections_views_and_rays(tomography, slope):
    figure = tomography_panel(tomography, slope)
    told = texts(figure)
    assert "Slice at 870 m" in told
    assert "West to east, at northing 4518.25 km" in told
    assert {"Mean density (g/cm³)", "Mean rays per voxel crossed", "Ground at the slice"} <= {*told}
    assert not [text for text in told if text.startswith("Standard error")]
    cells = [one for one in figure.findobj() if one.get_gid() == "cells"]
    # Two sections, and two blocks of three views.
    assert len(cells) == 8
    grounds = [one for one in figure.findobj() if one.get_gid() == "ground"]
    across, up = grounds[0].get_data()
    inside = np.isfinite(up)
    assert up[inside] == pytest.approx(plane(across, 4_518_250.0)[inside])
    marks = [one.get_xydata().tolist() for one in figure.findobj() if one.get_gid() == "target"]
    assert marks == [[[451_250.0, 870.0]], [[4_518_250.0, 870.0]]]
    assert in_the_page(figure) is True


def test_the_panel_shows_errors_where_they_are_known(tomography):
    deviation = tomography.density.with_values(
        "density_error", np.where(tomography.density.known, 0.1, np.nan)
    )
    figure = tomography_panel(replace(tomography, deviation=deviation))
    assert "Standard error of the density (g/cm³)" in texts(figure)
    assert len([one for one in figure.findobj() if one.get_gid() == "cells"]) == 11


@pytest.mark.parametrize(
    ("shape", "size"),
    [((40, 3, 2), (50, 50, 10)), ((3, 30, 20), (50, 50, 50)), ((2, 2, 40), (30, 30, 30)),
     ((1, 1, 1), (100, 100, 100))],
)  # fmt: skip
def test_volumes_of_any_shape_fit_the_page(shape, size):
    grid = VoxelGrid((300_000.0, -4_000_000.0, -200.0), tuple(map(float, size)), shape)
    one = make(grid, target=None, stations=1)
    one = replace(
        one,
        density=one.density.with_values("density", np.full(shape, REFERENCE)),
        coverage=one.coverage.with_values("coverage", np.ones(shape)),
    )
    for figure in (tomography_panel(one), known_model_panel(one, one.density)):
        assert in_the_page(figure) is True


def test_a_section_tells_distance_ground_and_line(tomography, slope):
    points = [(451_000, 4_518_250), (451_600, 4_518_250)]
    figure = section_figure(tomography, points, slope, "A $ profile")
    assert any("0.6 km along the line" in text for text in texts(figure))
    (ground,) = [one for one in figure.findobj() if one.get_gid() == "ground"]
    distance, up = ground.get_data()
    inside = np.isfinite(up)
    expected = plane(451_000 + distance, 4_518_250.0)
    assert up[inside] == pytest.approx(expected[inside], abs=3)
    assert in_the_page(figure) is True


def test_the_errors_of_the_paper_stand_in_the_panel(tomography):
    truth = tomography.density.with_values("density", np.where(
        np.isfinite(tomography.coverage.values), REFERENCE, np.nan
    ))  # fmt: skip
    errors = paper_errors(tomography, truth)
    both = tomography.density.known
    found = np.where(both, tomography.density.values, 0).sum(axis=1) * 100
    known = np.where(both, REFERENCE, 0).sum(axis=1) * 100
    seen = both.any(axis=1)
    size = np.abs(found - known)[seen] / REFERENCE / 1e3
    assert errors["front"].mean == pytest.approx(size.mean())
    assert errors["front"].deviation == pytest.approx(size.std())
    told = texts(known_model_panel(tomography, truth))
    assert f"mean |ε| {size.mean():.3f} km, σ {size.std():.3f} km" in told
    assert told.count("Original T") == 6
    perfect = paper_errors(tomography, tomography.density)
    assert {name: error.mean for name, error in perfect.items()} == {
        "top": 0, "front": 0, "side": 0,
    }  # fmt: skip


def test_the_curve_is_the_misfit_and_ends_where_the_errors_are_reached(tomography):
    curve, bars = convergence_figure(tomography, 1.0).axes
    assert curve.lines[0].get_xydata().tolist() == [[0, 9], [1, 4], [2, 2], [3, 1.5], [4, 1]]
    assert "explained within the errors" in [one.get_label() for one in curve.lines]
    heights = [bar.get_height() for bar in bars.patches]
    assert heights == pytest.approx(np.sqrt([2.0, 3.0, 4.0]))
    # Without errors nothing says where to stop, and residuals are shares of the data.
    curve, bars = convergence_figure(make(known_errors=False)).axes
    assert "explained within the errors" not in [one.get_label() for one in curve.lines]
    assert [bar.get_height() for bar in bars.patches] == pytest.approx([10, 20, 30])


@pytest.mark.parametrize("misfit", [[3.0, 1.0], [500.0, 20.0, 1.1, 1.0, 0.9], [0.0, 0, 0, 0, 0]])
def test_curves_of_any_kind_are_drawn(tomography, misfit):
    found = replace(tomography.reconstruction, misfit=np.array(misfit))
    figure = convergence_figure(replace(tomography, reconstruction=found))
    assert in_the_page(figure) is True


def test_many_stations_with_long_names_stay_in_the_page():
    names = make(stations=60)
    long = tuple(replace(one, name=f"muogram of the {one.name} station") for one in names.residuals)
    assert in_the_page(convergence_figure(replace(names, residuals=long))) is True


# Reports.


@pytest.fixture
def dem(data_folder):
    from muysc_qgis.topography.dem import open_dem

    return open_dem(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture
def on_the_map(tomography):
    from pyproj import CRS

    wkt = CRS.from_epsg(32633).to_wkt()
    return replace(
        tomography,
        density=replace(tomography.density, crs=wkt),
        coverage=replace(tomography.coverage, crs=wkt),
    )


TOLD = Provenance([Row("Method", "sirt")], {"Density": "/d/<b>.tif"}, "today", {})


def test_the_report_tells_numbers_rays_and_warnings(on_the_map, dem):
    line = [(451_000, 4_518_250), (451_600, 4_518_250)]
    told = documents.report(on_the_map, dem, TOLD, warnings=["First."], line_m=line)
    assert [figure.is_panel for figure in told.figures] == [True, False, False]
    values = {row.label: row.value for row in told.results}
    assert values["Rays used"] == 30
    assert values["Relative residual"] == 5.0
    assert values["Mean square of residuals over their errors"] == 2.0
    assert [(one.label, one.count) for one in told.pixels] == [("Used", 30), ("Not used", 7)]
    assert told.pixel_total == 37
    document = report_html(told)
    assert "One &lt;sentence&gt;." in document
    assert "First." in document
    assert "&lt;b&gt;.tif" in document


def test_the_report_of_a_test_holds_bodies_and_the_errors_of_the_paper(on_the_map, dem):
    bodies = (BodyFound("<conduit>", 12, 9, 0.8125), BodyFound("hidden", 3, 0, float("nan")))
    found = KnownModelResult(on_the_map, on_the_map.density, bodies, 0.01, 0.02, -0.03, 1234.6)
    told = documents.known_model_report(found, dem, TOLD)
    values = {row.label: (row.value, row.unit) for row in told.results}
    assert values["Contrast found over the true one, <conduit>"] == (0.8125, "")
    assert values["Voxels of <conduit> crossed by rays"] == ("9 of 12", "")
    assert values["Mean of R − T"] == (-0.03, "g/cm³")
    assert values["Muons counted"] == (1235, "")
    assert values["Top view, normalised: mean |ε|"] == (0, "")
    assert values["Front view: standard deviation of |ε|"] == (0, "km")
    assert told.figures[0].is_panel
    assert not told.figures[1].is_panel
    document = report_html(told)
    assert "&lt;conduit&gt;" in document
    assert ">unknown<" in document


def test_the_panel_is_drawn_on_the_terrain(on_the_map, dem):
    assert png_bytes(documents.panel(on_the_map, dem), 40).startswith(b"\x89PNG")

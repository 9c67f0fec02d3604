"""Pictures of a survey hold what they promise."""

import numpy as np
import pytest

from muysc_qgis.plots.provenance import Provenance
from muysc_qgis.plots.report import report_html
from muysc_qgis.plots.survey_documents import panel, report
from muysc_qgis.plots.survey_map import SurveyMap
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.candidates import Limits, find_candidates
from muysc_qgis.survey.map_grid import grid_around
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.site_assessment import SurveyPlan
from muysc_qgis.workflows.site_selection import Wanted, select_sites
from muysc_qgis.workflows.view_settings import ViewSettings

TARGET = (14.4262, 40.8216)


@pytest.fixture(scope="module")
def survey(data_folder, tmp_path_factory):
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    plan = SurveyPlan(
        dem, TARGET, -100.0, 1.0, ViewSettings(Aperture(50, 30, 8, 6), Physics(), Telescope())
    )
    grid = grid_around(dem, TARGET, 2500.0, 700.0)
    candidates = find_candidates(dem, TARGET, grid, Limits(1200.0, 2500.0))
    folder = tmp_path_factory.mktemp("survey") / "x.partial"
    return select_sites(plan, candidates, Wanted(best=3, telescopes=2), folder, 0), plan


def test_the_map_has_every_candidate_within_and_the_sites_where_they_are(survey):
    selection, plan = survey
    maps = SurveyMap.of(selection, plan)
    assert np.hypot(maps.east_m, maps.north_m).max() < maps.half_m
    # The cell of each candidate surrounds it.
    row, column = np.divmod(selection.candidates.cell, selection.candidates.grid.columns)
    for corner, place in ((maps.corner_east_m, maps.east_m), (maps.corner_north_m, maps.north_m)):
        ends = np.stack([corner[row + i, column + j] for i in (0, 1) for j in (0, 1)])
        np.testing.assert_allclose(ends.mean(axis=0), place, atol=0.5)
    figure = panel(selection, plan)
    texts = {text.get_text() for axes in figure.axes for text in axes.texts}
    assert {"1", "2", "3"} <= texts


def test_the_report_lists_every_site(survey):
    selection, plan = survey
    html = report_html(report(selection, plan, Provenance()))
    for words in ("Site 3", "Telescope 2", "Nemhauser", "Dembinski", "nearer than 1200 m"):
        assert words in html
    assert html.count("data:image/png;base64") == 2

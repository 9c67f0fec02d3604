"""Whether a survey sees a body, in counts along the telescopes' own trajectories."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.ring import Ring, ring_places
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.tomography.counting import CountPriors
from muysc_qgis.tomography.counting.score import elsewhere
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.workflows.count_tomography import CountChoices
from muysc_qgis.workflows.known_model import KnownModel
from muysc_qgis.workflows.simulated_counts import Campaign
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.sites import Site, stations_of
from muysc_qgis.workflows.survey_verdict import judge_survey, telescopes_at
from muysc_qgis.workflows.volume_frame import utm_zone
from muysc_qgis.workflows.volume_plan import VolumePlan

SUMMIT, ROCK = (14.429444, 40.822222), 2.65
CRS = utm_zone(*SUMMIT)
X, Y = from_wgs84(CRS, *SUMMIT)
PLAN = VolumePlan((X - 600, X + 600, Y - 600, Y + 600), 100.0, None, 900.0, 1300.0)
BODY = KnownModel("sphere", ROCK, ROCK - 0.6, 170.0, middle_m=1060.0, centre=(X, Y))
CHOICES = CountChoices(ROCK, CountPriors(ROCK, station=0.05, flux=0.05))
TELESCOPE = Telescope(trajectories=trajectories(TelescopeGeometry(8, 8, 8.0, 100.0)))


@pytest.fixture(scope="module")
def stations(dem):
    places = ring_places(dem, SUMMIT, Ring(900.0, 4, sees_target=False))
    sites = [Site(f"s{n}", place, 2.0, f"s{n}") for n, place in enumerate(zip(places.x, places.y))]
    return stations_of(dem, sites, SUMMIT, 0.0, Aperture(60.0, 30.0, 12, 8))[0]


def judged(stations, dem, model, days=100.0, pixels=12, telescope=TELESCOPE, draws=2):
    campaign = Campaign(days, telescope)
    aperture = Aperture(60.0, 30.0, pixels, 8)
    telescopes = telescopes_at(stations, aperture, Physics(density_g_cm3=ROCK), campaign, 0.9)
    return judge_survey(telescopes, dem, PLAN, model, campaign, CHOICES, draws, CRS)


def test_a_body_is_seen_where_it_is(stations, dem):
    found = judged(stations, dem, BODY, days=140.0)
    verdict = found.verdict
    assert verdict.significance > 5
    assert verdict.overall < verdict.significance
    assert verdict.seen == 1
    assert verdict.place_m < 200
    assert 0.2 < verdict.contrast < 1.2
    assert verdict.chi_squared == pytest.approx(1.0, abs=0.25)
    assert "can see the body" in verdict.text
    assert found.tomography.method == "counts"


def test_no_days_show_nothing(stations, dem):
    found = judged(stations, dem, BODY, days=0.02)
    assert found.verdict.significance < 4
    assert "cannot see the body" in found.verdict.text


def test_muons_do_not_depend_on_pixels(stations, dem):
    one, other = (judged(stations, dem, BODY, pixels=n, draws=1).muons for n in (12, 30))
    assert one == other


def test_a_mountain_without_a_body_gives_no_alarm(stations, dem):
    found = judged(stations, dem, KnownModel("uniform", ROCK), draws=3)
    assert not np.isfinite(found.verdict.significance)
    assert found.verdict.false_alarms < 0.5
    assert found.verdict.text.startswith("There is no body")


def test_pixels_serve_where_no_telescope_is_chosen(stations, dem):
    found = judged(stations, dem, BODY, telescope=Telescope(8.0), draws=1)
    assert found.verdict.significance > 3


def test_looking_in_many_places_costs_standard_errors():
    for score, places in ((3.0, 50.0), (5.0, 1000.0), (12.0, 1e6)):
        expected = norm.isf(-np.expm1(places * np.log1p(-norm.sf(score))))
        assert elsewhere(score, places) == pytest.approx(expected, rel=1e-3)
    assert elsewhere(4.0, 1.0) == pytest.approx(4.0)
    assert 38 < elsewhere(40.0, 1e6) < 40


def test_wrong_numbers_are_refused(stations, dem):
    with pytest.raises(MuyscError, match="0 draws show nothing"):
        judged(stations, dem, BODY, draws=0)
    with pytest.raises(MuyscError, match="efficiency of 2 is impossible"):
        telescopes_at(stations, Aperture(60.0, 30.0, 12, 8), Physics(), Campaign(), 2.0)
    with pytest.raises(MuyscError, match="outside the rock of the volume"):
        judged(stations, dem, replace(BODY, centre=(X + 5000, Y)))

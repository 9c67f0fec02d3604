"""What must not change when the same scene is described in another way."""

from dataclasses import replace

import numpy as np
import pytest
from osgeo import gdal, osr
from pyproj import Transformer

from muysc_qgis.muogram import Muogram
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.simulation import Telescope, simulate, through_rock

gdal.UseExceptions()

LONGITUDE, LATITUDE = 14.4, 40.8
#: Azimuth and distance are true from its middle, where the detector stands.
AROUND = f"+proj=aeqd +lon_0={LONGITUDE} +lat_0={LATITUDE} +datum=WGS84 +units=m"
CELLS, CELL_M = 241, 15.0
APERTURE = Aperture(50.0, 24.0, 26, 12)
#: East, north, height and width (m) of hills that look different from all sides.
HILLS = ((700, 150, 420, 230), (250, 800, 260, 190), (-600, 500, 340, 260), (-300, -800, 300, 210))


def hills(east, north):
    return sum(
        height * np.exp(-((east - x) ** 2 + (north - y) ** 2) / (2 * width**2))
        for x, y, height, width in HILLS
    )


@pytest.fixture
def terrain(tmp_path):
    """Write heights, given as an array or as a function of east and north, and open them."""

    def write(heights, name="dem", crs=AROUND, middle=(0.0, 0.0), cell=(CELL_M, CELL_M)):
        left, top = (middle[0] - CELLS / 2 * cell[0], middle[1] + CELLS / 2 * cell[1])
        if callable(heights):
            x, y = np.meshgrid(
                left + (np.arange(CELLS) + 0.5) * cell[0], top - (np.arange(CELLS) + 0.5) * cell[1]
            )
            to_plane = Transformer.from_crs(crs, AROUND, always_xy=True)
            heights = heights(*to_plane.transform(x, y))
        path = str(tmp_path / f"{name}.tif")
        dataset = gdal.GetDriverByName("GTiff").Create(path, CELLS, CELLS, 1, gdal.GDT_Float64)
        dataset.SetGeoTransform((left, cell[0], 0, top, 0, -cell[1]))
        reference = osr.SpatialReference()
        reference.SetFromUserInput(crs)
        dataset.SetProjection(reference.ExportToWkt())
        dataset.GetRasterBand(1).WriteArray(heights)
        del dataset
        return open_dem(path)

    return write


def view(dem, target, detector=(0.0, 0.0), height=1.0, **limits):
    """Return the simulation of a detector that looks at a target."""
    sight = take_sight(dem, detector, target, height)
    return simulate(sight, APERTURE, Physics(), Telescope(), **limits)


def thickness(simulation):
    return simulation.muograms["thickness"].values


def heights_on_grid(east_turn=1.0):
    across = (np.arange(CELLS) - CELLS // 2) * CELL_M
    return hills(*np.meshgrid(across * east_turn, -across))


@pytest.mark.parametrize("quarters", [1, 2, 3])
def test_a_quarter_turn_of_everything_changes_nothing(terrain, quarters):
    straight = view(terrain(heights_on_grid()), (700.0, 150.0))
    x, y = 700.0, 150.0
    for _ in range(quarters):
        x, y = y, -x  # clockwise from above, as azimuths go
    turned = view(terrain(np.rot90(heights_on_grid(), -quarters), "turned"), (x, y))
    assert thickness(straight).max() > 300
    np.testing.assert_allclose(thickness(turned), thickness(straight), rtol=1e-6, atol=1e-6)
    for quantity in ("flux", "open_sky", "exposure"):
        np.testing.assert_allclose(
            turned.muograms[quantity].values, straight.muograms[quantity].values, rtol=1e-5
        )
    azimuths = turned.muograms["flux"].azimuth_deg - straight.muograms["flux"].azimuth_deg
    np.testing.assert_allclose((azimuths - 90.0 * quarters) % 360.0 % 359.999999, 0.0, atol=1e-5)


def test_a_mirror_image_is_seen_mirrored(terrain):
    straight = thickness(view(terrain(heights_on_grid()), (700.0, 150.0)))
    mirrored = thickness(view(terrain(heights_on_grid(-1.0), "mirrored"), (-700.0, 150.0)))
    np.testing.assert_allclose(mirrored[:, ::-1], straight, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("angle", [17.0, 33.3, 45.0])
def test_any_turn_of_everything_changes_little(terrain, angle):
    """Hills as wide as 13 cells: bilinear cells err by height · cell² / 8 width² = 0.2 m."""
    cos, sin = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    straight = thickness(view(terrain(hills), (700.0, 150.0)))
    x, y = 700 * cos + 150 * sin, -700 * sin + 150 * cos
    surface = terrain(lambda e, n: hills(e * cos - n * sin, e * sin + n * cos), "turned")
    turned = thickness(view(surface, (x, y)))
    rock = (straight > 0) & (turned > 0)
    assert np.count_nonzero(rock) > 90
    assert np.abs(turned - straight)[rock].mean() < 0.004 * straight[rock].mean()
    # Only at the skyline may a ray see rock in one and sky in the other.
    assert np.count_nonzero((straight > 0) != (turned > 0)) <= 5


#: Reference system, and its unit (across, up) for a metre here.
SYSTEMS = [
    ("EPSG:32633", 1.0),
    ("EPSG:3035", 1.0),
    ("EPSG:3857", 1.32),
    ("EPSG:4326", (1 / 84_400, 1 / 111_050)),
    ("+proj=tmerc +lon_0=14 +lat_0=40 +datum=WGS84 +units=us-ft", 3.28),
]


@pytest.mark.parametrize(("crs", "metre"), SYSTEMS)
def test_another_reference_system_changes_little(terrain, crs, metre):
    to_crs = Transformer.from_crs(AROUND, crs, always_xy=True)
    detector, target = to_crs.transform(0.0, 0.0), to_crs.transform(700.0, 150.0)
    cell = tuple(np.broadcast_to(metre, 2) * CELL_M)
    straight = thickness(view(terrain(hills), (700.0, 150.0)))
    other = thickness(view(terrain(hills, "other", crs, detector, cell), target, detector))
    rock = (straight > 0) & (other > 0)
    assert np.abs(other - straight)[rock].mean() < 0.004 * straight[rock].mean()
    assert np.count_nonzero((straight > 0) != (other > 0)) <= 5


def test_a_higher_sea_changes_nothing(terrain):
    straight = view(terrain(heights_on_grid()), (700.0, 150.0))
    raised = view(terrain(heights_on_grid() + 1234.0, "raised"), (700.0, 150.0))
    np.testing.assert_allclose(thickness(raised), thickness(straight), rtol=1e-9, atol=1e-6)


def test_two_halves_of_a_field_of_view_make_the_whole(terrain):
    sight = take_sight(terrain(heights_on_grid()), (0.0, 0.0), (700.0, 150.0), 1.0)
    whole = simulate(sight, APERTURE, Physics(), Telescope()).muograms
    quarter = APERTURE.azimuth_width_deg / 4
    half = Aperture(2 * quarter, APERTURE.elevation_width_deg, 13, APERTURE.elevation_pixels)
    sides = [
        simulate(
            replace(sight, boresight_azimuth_deg=sight.boresight_azimuth_deg + turn), half,
            Physics(), Telescope(),
        ).muograms
        for turn in (-quarter, quarter)
    ]  # fmt: skip
    for quantity in ("thickness", "flux", "distance"):
        both = np.concatenate([side[quantity].values for side in sides], axis=1)
        # Directions differ in their last digit, which counts most at the skyline.
        np.testing.assert_allclose(both, whole[quantity].values, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("border_m", [500.0, 650.0, 777.7])
def test_near_and_far_rock_add_up(terrain, border_m):
    dem = terrain(heights_on_grid())
    whole = thickness(view(dem, (700.0, 150.0)))
    near = thickness(view(dem, (700.0, 150.0), max_range_m=border_m))
    far = thickness(view(dem, (700.0, 150.0), near_field_m=border_m))
    assert np.count_nonzero((near > 0) & (far > 0)) > 5
    np.testing.assert_allclose(near + far, whole, rtol=1e-9, atol=1e-6)


def bump(east, north, height, radius):
    """Return a hill that ends, so that the plain around it is level."""
    across = (np.arange(CELLS) - CELLS // 2) * CELL_M
    distance = np.hypot(across[None, :] - east, -across[:, None] - north)
    return height * np.clip(1 - (distance / radius) ** 2, 0, None)


def test_hills_one_behind_the_other_add_up(terrain):
    near, far = bump(550, 30, 240, 250), bump(1200, -80, 420, 350)
    seen = []
    for name, heights in (("near", near), ("far", far), ("both", near + far)):
        sight = take_sight(terrain(heights, name), (0.0, 0.0), (700.0, 0.0), 5.0)
        # Above the horizon, and the same for all.
        sight = replace(sight, boresight_elevation_deg=13.0)
        seen.append(thickness(simulate(sight, APERTURE, Physics(), Telescope())))
    assert np.count_nonzero((seen[0] > 0) & (seen[1] > 0)) > 20
    np.testing.assert_allclose(seen[0] + seen[1], seen[2], rtol=1e-9, atol=1e-6)


def rock(values, density):
    elevation = np.linspace(40.0, 2.0, 8)
    metadata = {"DETECTOR_ELEVATION": 500.0}
    muogram = Muogram("thickness", values, np.arange(5.0), elevation, metadata)
    return through_rock(muogram, Physics(density_g_cm3=density), Telescope()).muograms


@pytest.mark.parametrize("factor", [2.0, 3.7])
def test_denser_rock_is_like_more_of_it(factor):
    values = np.random.default_rng(3).uniform(0, 1500, (8, 5))
    longer, denser = rock(values, 2.0), rock(values / factor, 2.0 * factor)
    for quantity in ("opacity", "minimum_energy", "flux", "transmission", "exposure"):
        np.testing.assert_allclose(
            denser[quantity].values, longer[quantity].values, rtol=1e-9, err_msg=quantity
        )


def test_more_rock_never_lets_more_muons_through():
    values = np.sort(np.random.default_rng(4).uniform(0, 3000, (8, 5)), axis=1)
    flux = rock(values, 2.65)["flux"].values
    assert (np.diff(flux, axis=1) <= 0).all()

"""Real terrain against rays marched in small steps in three dimensions.

The march shares nothing with the library: rays are straight in Earth-centred
coordinates, each step is taken back to geodetic ones on the DEM's ellipsoid and
compared with scipy's bilinear interpolation of the raster.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from osgeo import gdal
from pyproj import Transformer
from pyproj.enums import TransformDirection
from scipy.ndimage import map_coordinates

from muysc_qgis.radiography.raytracing import Outcome

STEP_M = 2.0
BLOCK = 64


@dataclass(frozen=True)
class March:
    """What a march found, one value for each ray."""

    thickness: np.ndarray
    first: np.ndarray
    #: In rock at the last step with known ground under it.
    ends_in_rock: np.ndarray
    #: Crosses unknown ground between known.
    crosses_gap: np.ndarray


class Terrain:
    """A raster and the geodetic coordinates of its CRS, by GDAL and PROJ alone."""

    def __init__(self, path, ellipsoid, projection=None):
        dataset = gdal.Open(str(path))
        self.geotransform = dataset.GetGeoTransform()
        band = dataset.GetRasterBand(1)
        self.heights = band.ReadAsArray().astype(float)
        no_data = band.GetNoDataValue()
        if no_data is not None:
            self.heights[self.heights == no_data] = np.nan
        self.cartesian = Transformer.from_pipeline(
            f"+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad "
            f"+step +proj=cart +ellps={ellipsoid}"
        )
        self.project = projection and Transformer.from_pipeline(
            f"+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step {projection}"
        )

    def position(self, x, y):
        if self.project is None:
            return x, y
        return self.project.transform(x, y, direction=TransformDirection.INVERSE)

    def ground(self, longitude, latitude):
        x, y = (longitude, latitude)
        if self.project is not None:
            x, y = self.project.transform(longitude, latitude)
        x0, dx, _, y0, _, dy = self.geotransform
        at = [(y - y0) / dy - 0.5, (x - x0) / dx - 0.5]
        return map_coordinates(self.heights, at, order=1, mode="constant", cval=np.nan)

    def march(self, x, y, eye, azimuth, elevation, length):
        """March rays of (n,) directions from (x, y) at height eye."""
        longitude, latitude = self.position(x, y)
        start = np.array(self.cartesian.transform(longitude, latitude, eye))
        lon, lat = np.radians([longitude, latitude])
        east = np.array([-np.sin(lon), np.cos(lon), 0.0])
        north = np.array([-np.sin(lat) * np.cos(lon), -np.sin(lat) * np.sin(lon), np.cos(lat)])
        up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
        az, el = np.radians(azimuth)[:, None], np.radians(elevation)[:, None]
        direction = np.cos(el) * (np.sin(az) * east + np.cos(az) * north) + np.sin(el) * up
        steps = np.arange(STEP_M / 2, length, STEP_M)
        parts = [
            self._march_block(start, direction[first : first + BLOCK], steps)
            for first in range(0, len(direction), BLOCK)
        ]
        return March(*(np.concatenate(values) for values in zip(*parts)))

    def _march_block(self, start, direction, steps):
        points = start + steps[None, :, None] * direction[:, None, :]
        longitude, latitude, height = self.cartesian.transform(
            *np.moveaxis(points, -1, 0).reshape(3, -1), direction=TransformDirection.INVERSE
        )
        ground = self.ground(longitude, latitude).reshape(len(direction), -1)
        known = np.isfinite(ground)
        rock = known & (height.reshape(ground.shape) < ground)
        last = known.shape[1] - 1 - np.argmax(known[:, ::-1], axis=1)
        gap = ~known & (np.arange(known.shape[1]) < last[:, None])
        return (
            rock.sum(axis=1) * STEP_M,
            np.where(rock.any(axis=1), steps[np.argmax(rock, axis=1)], np.nan),
            rock[np.arange(len(rock)), last],
            gap.any(axis=1),
        )


def assert_agrees(rock, march):
    """Check thickness and first rock of (n, 1) rays, those of known thickness."""
    thickness, first = rock.thickness_m[:, 0], rock.distance_m[:, 0]
    known = rock.outcome[:, 0] == Outcome.KNOWN
    compared = known & ~march.ends_in_rock & ~march.crosses_gap
    error = np.abs(thickness - march.thickness)[compared]
    through = compared & (thickness > 10.0)
    relative = np.abs(thickness - march.thickness)[through] / thickness[through]
    assert np.count_nonzero(through) > 100
    assert np.median(relative) < 0.003
    assert np.percentile(error, 99) < 10.0
    both = compared & np.isfinite(first) & np.isfinite(march.first)
    off = np.abs(first - march.first)[both]
    assert np.median(off) < STEP_M
    # A ray that grazes a ridge thinner than a step differs by a whole valley.
    assert np.mean(off > 3 * STEP_M) < 0.02


def scattered(azimuth, elevation, count, seed):
    generator = np.random.default_rng(seed)
    azimuths = generator.uniform(*azimuth, count)
    return azimuths, generator.uniform(*elevation, count)


def test_vesuvius_from_casina_amelia(data_folder, trace):
    path = str(data_folder / "vesuvius_srtmgl1.tif")
    terrain = Terrain(path, "WGS84")
    x, y = 14.410686, 40.810561
    # 42° × 22° around the line to (14.424745, 40.823729), which is 39.0° from
    # north and 17.5° up.
    azimuth, elevation = scattered((18.0, 60.0), (6.5, 28.5), 1000, seed=1)
    eye = float(terrain.ground(np.array([x]), np.array([y]))[0]) + 1.0
    rock = trace(path, azimuth, elevation[:, None], x, y, eye=eye)
    assert_agrees(rock, terrain.march(x, y, eye, azimuth, elevation, 6000.0))


def test_st_helens_with_its_missing_wedges(data_folder, trace):
    path = str(data_folder / "st_helens_usgs.tif")
    terrain = Terrain(path, "clrk66", "+proj=utm +zone=10 +ellps=clrk66")
    x, y = 562_300.0, 5_119_000.0  # on the pumice plain, the crater to the south
    azimuth, elevation = scattered((0.0, 360.0), (-6.0, 14.0), 700, seed=2)
    eye = float(terrain.ground(*terrain.position(np.array([x]), np.array([y])))[0]) + 2.0
    rock = trace(path, azimuth, elevation[:, None], x, y, eye=eye)
    march = terrain.march(x, y, eye, azimuth, elevation, 12_000.0)
    assert_agrees(rock, march)
    # Where the march is in rock at the last known ground, the thickness is unknown.
    unknown = np.isnan(rock.thickness_m[:, 0])
    assert np.count_nonzero(unknown) > 20
    assert np.mean(unknown == (march.ends_in_rock | march.crosses_gap)) > 0.99


def test_maungawhau_south_of_the_equator(data_folder, trace):
    path = str(data_folder / "maungawhau_linz5m.tif")
    terrain = Terrain(
        path, "GRS80",
        "+proj=tmerc +lat_0=0 +lon_0=173 +k=0.9996 +x_0=1600000 +y_0=10000000 +ellps=GRS80",
    )  # fmt: skip
    x, y = 1_757_020.0, 5_917_450.0  # west of the cone
    azimuth, elevation = scattered((70.0, 160.0), (3.0, 25.0), 700, seed=3)
    eye = float(terrain.ground(*terrain.position(np.array([x]), np.array([y])))[0]) + 1.0
    rock = trace(path, azimuth, elevation[:, None], x, y, eye=eye)
    march = terrain.march(x, y, eye, azimuth, elevation, 800.0)
    assert_agrees(rock, march)


def test_cerro_machin_is_as_thick_as_an_independent_sampler_found(data_folder, trace):
    path = str(data_folder / "machin_digitised.tif")
    terrain = Terrain(path, "WGS84")
    x, y = -75.381092, 4.492298
    eye = float(terrain.ground(np.array([x]), np.array([y]))[0]) + 1.0
    # 10–15° left of the line to (4.487717 N, −75.387880 E), which is 236.08° from
    # north; zenith 84°. The physics reference gives 1.29–1.32 km, to 10 m.
    azimuth = 236.08 - np.linspace(10.0, 15.0, 11)
    rock = trace(path, azimuth, 6.0, x, y, eye=eye)
    assert rock.thickness_m.min() > 1285.0
    assert rock.thickness_m.max() < 1325.0
    march = terrain.march(x, y, eye, azimuth, np.full(11, 6.0), 2600.0)
    np.testing.assert_allclose(rock.thickness_m[:, 0], march.thickness, rtol=0.003)


@pytest.mark.parametrize("lift", [0.0, 5000.0])
def test_altitude_leaves_the_thickness_right_to_a_thousandth(metric_dem, trace, place, lift):
    # Distances are taken along the ellipsoid, where they are shorter by h/R than at
    # an altitude h: 0.08 % at 5 km.
    def hill(east, north):
        return lift + 800.0 * np.exp(-((east - 1500.0) ** 2 + north**2) / (2 * 400.0**2))

    path = metric_dem(hill, 20.0, 3000.0)
    terrain = Terrain(
        path, "WGS84",
        f"+proj=aeqd +lon_0={place.longitude} +lat_0={place.latitude} +ellps=WGS84",
    )  # fmt: skip
    azimuth, elevation = scattered((75.0, 105.0), (4.0, 20.0), 200, seed=4)
    eye = lift + 5.0
    rock = trace(path, azimuth, elevation[:, None], eye=eye)
    march = terrain.march(0.0, 0.0, eye, azimuth, elevation, 4000.0)
    thickness = rock.thickness_m[:, 0]
    through = thickness > 200.0
    bias = np.mean(thickness[through] / march.thickness[through]) - 1
    assert np.count_nonzero(through) > 50
    assert abs(bias) < 0.001

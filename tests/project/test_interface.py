"""What scripts, models and histories store is there for good: names may be added, none may go."""

import pytest
from osgeo import gdal

from muysc_qgis.muogram import write_muogram
from muysc_qgis.quantities import QUANTITIES
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.trajectories import maps_of, write_trajectories
from muysc_qgis.workflows.simulation import Telescope, simulate

gdal.UseExceptions()

#: Units of what rasters hold, by the name in their metadata.
UNITS = {
    "thickness": "m", "opacity": "g/cm²", "minimum_energy": "GeV", "flux": "cm⁻² sr⁻¹ day⁻¹",
    "open_sky": "cm⁻² sr⁻¹ day⁻¹", "transmission": "1", "exposure": "days", "counts": "1",
    "density": "g/cm³", "distance": "m",
}  # fmt: skip

#: What a raster says of itself, in the metadata domain MUYSC: any, a simulated muogram, and
#: one in telescope angles.
ANY_RASTER = "QUANTITY UNIT VERSION"
MUOGRAM = f"""
    {ANY_RASTER} DETECTOR_LON DETECTOR_LAT DETECTOR_ELEVATION DETECTOR_HEIGHT BORESIGHT_AZIMUTH
    BORESIGHT_ELEVATION TARGET_LON TARGET_LAT TARGET_ELEVATION TARGET_DISTANCE DEM DEM_CRS
    NEAR_FIELD MATERIAL DENSITY FLUX_MODEL GAISSER_PARAMETERS ENERGY_LOSS STRAGGLING
    ALTITUDE_CORRECTION DETECTION_THRESHOLD FLUX_ERROR ACCEPTANCE MUONS"""
#: What it says besides where the terrain is not on WGS 84.
OTHER_DATUM = "TRANSFORMATION TRANSFORMATION_ACCURACY"
TELESCOPE_ANGLES = f"""
    {ANY_RASTER} PROJECTION AXIS_X AXIS_Y TELESCOPE BARS_X BARS_Y PIXEL_SIZE SEPARATION PLANES
    TANGENT_STEP FORMULA"""

MATERIALS = """
    standard_rock water ice limestone dolomite quartzite granite granodiorite diorite andesite
    basalt gabbro concrete"""
FLUX_MODELS = "gaisser gaisser-tang bugaev reyna-bugaev reyna-hebbeker guan gsf-sibyll"
PRESETS = """
    custom mute gibert2010 carbone2014 lopresti2020 lesparre2012 lesparre2010 uchida2009 muraves"""
METHODS = """
    art bart sart sirt mlem osem pml-quad pml-hybrid ospml-quad ospml-hybrid tv grad tikhonov lsmr
    bayes"""

#: The words of a choice, by its parameter: the same wherever it stands.
WORDS = {
    "HEIGHT_UNIT": "auto metre foot us_survey_foot",
    "MATERIAL": MATERIALS,
    "MATERIALS": MATERIALS,
    "FLUX_MODEL": FLUX_MODELS,
    "FLUX_MODELS": FLUX_MODELS,
    "GAISSER_PARAMETERS": "volkova gaisser klimushin aglietta ambrosio",
    "ENERGY_LOSS": "csda lesparre paper",
    "PRESET": PRESETS,
    "FORMULA": "exact paper",
    "METHOD": METHODS,
    "METHODS": f"{METHODS} fbp gridrec",
    "ORDERING": "interleaved sequential random",
    "MODEL": "uniform checkerboard conduit sphere polygons",
    "STATISTICS": "poisson lesparre",
    "SIDE": "near far",
    "QUANTITY": """
        counts flux transmission thickness opacity density open_sky exposure distance""",
    "QUANTITIES": """
        thickness opacity flux minimum_energy open_sky transmission exposure distance""",
    "LAYOUT": "auto table matrix",
    "VERTICAL_ANGLE": "auto elevation zenith",
    "ANGLE_UNIT": "auto degrees radians",
    "AZIMUTH_SENSE": "clockwise counterclockwise",
}

TERRAIN = "DEM BAND HEIGHT_UNIT"
SIGHT = "DETECTOR DETECTOR_HEIGHT TARGET TARGET_HEIGHT"
APERTURE = "AZIMUTH_APERTURE ELEVATION_APERTURE AZIMUTH_PIXELS ELEVATION_PIXELS"
REACH = "MAX_RANGE NEAR_FIELD"
FLUX = (
    "FLUX_MODEL GAISSER_PARAMETERS ENERGY_LOSS STRAGGLING ALTITUDE_CORRECTION DETECTION_THRESHOLD"
)
PHYSICS = f"MATERIAL DENSITY {FLUX}"
TELESCOPE = "PRESET BARS_X BARS_Y PIXEL_SIZE SEPARATION FORMULA"
PIXEL = f"ACCEPTANCE MUONS {TELESCOPE}"
RECONSTRUCTION = """
    EXTENT VOXEL_SIZE VOXELS BASE TOP CRS TERRAIN_MASK MEMORY METHOD ITERATIONS RELAXATION
    REGULARIZATION REFERENCE_DENSITY RELATIVE_ERROR LENGTH_ERROR NONNEGATIVE HIGHEST_DENSITY
    ORDERING SUBSETS DISCREPANCY EDGE_DENSITY PRIOR_DEVIATION CORRELATION_LENGTH
    POSTERIOR_SAMPLES"""

#: Parameters, files and numbers of every algorithm.
INTERFACE = {
    "radiography": (
        f"{TERRAIN} {SIGHT} {APERTURE} {REACH} {PHYSICS} {PIXEL} TERRAIN_ERROR TERRAIN_CORRELATION"
        " POINTING_ERROR",
        """THICKNESS OPACITY MINIMUM_ENERGY FLUX OPEN_SKY TRANSMISSION EXPOSURE DISTANCE
        FLUX_MINIMUM FLUX_MAXIMUM THICKNESS_ERROR FIELD_OF_VIEW PANEL REPORT""",
        """MAX_THICKNESS DETECTOR_ELEVATION BORESIGHT_AZIMUTH BORESIGHT_ELEVATION TARGET_DISTANCE
        ROCK_PIXELS UNKNOWN_PIXELS MEDIAN_EXPOSURE""",
    ),
    "drape": (f"MUOGRAM {TERRAIN} SIDE", "OUTPUT", "CELLS"),
    "muonflux": (
        f"THICKNESS OPACITY DETECTOR_ELEVATION {PHYSICS} {PIXEL}",
        """THICKNESS_OUTPUT OPACITY_OUTPUT MINIMUM_ENERGY FLUX OPEN_SKY TRANSMISSION EXPOSURE
        FLUX_MINIMUM FLUX_MAXIMUM PANEL REPORT""",
        "MAX_THICKNESS ROCK_PIXELS UNKNOWN_PIXELS MEDIAN_EXPOSURE",
    ),
    "density": (
        f"""THICKNESS {TERRAIN} DETECTOR DETECTOR_HEIGHT COUNTS FLUX TRANSMISSION ERROR EXPOSURE
        ACCEPTANCE ACCEPTANCES OPEN_SKY_COUNTS
        OPEN_SKY_EXPOSURE MINIMUM_COUNTS MODEL_UNCERTAINTY LIMIT_CONFIDENCE DETECTOR_ELEVATION
        MATERIAL {FLUX}""",
        """OPACITY DENSITY DENSITY_ERROR DENSITY_LOWER DENSITY_UPPER DENSITY_MINIMUM DENSITY_MAXIMUM
        FLAGS REGION_NUMBERS THICKNESS_SEEN PANEL REPORT""",
        """MEAN_DENSITY MEAN_DENSITY_ERROR MEAN_DENSITY_STATISTICAL_ERROR MEDIAN_DENSITY ROCK_PIXELS
        DENSITY_PIXELS LIMIT_PIXELS BRIGHT_PIXELS UNKNOWN_PIXELS REGIONS MIXED_PIXELS CHI_SQUARED
        SKY_RATIO""",
    ),
    "importmuogram": (
        """INPUT QUANTITY LAYOUT VERTICAL_ANGLE ANGLE_UNIT AZIMUTH_COLUMN VERTICAL_COLUMN
        VALUE_COLUMN ERROR_COLUMN FACTOR NO_DATA RELATIVE AZIMUTH_SENSE AZIMUTH_FIRST AZIMUTH_LAST
        VERTICAL_FIRST VERTICAL_LAST ERROR_INPUT REFERENCE DETECTOR DETECTOR_ELEVATION
        BORESIGHT_AZIMUTH BORESIGHT_ELEVATION EXPOSURE ACCEPTANCE""",
        "OUTPUT ERROR",
        "PIXELS UNKNOWN_PIXELS TOTAL",
    ),
    "telescope": (
        f"{TELESCOPE} PLANES",
        """ACCEPTANCE SOLID_ANGLE DETECTION_AREA PATH_LENGTH ANGULAR_RESOLUTION TABLE PANEL
        COMPARISON REPORT""",
        """MAX_ACCEPTANCE MAX_SOLID_ANGLE MAX_DETECTION_AREA APERTURE APERTURE_Y ANGULAR_STEP
        TRAJECTORIES ETENDUE""",
    ),
    "expectedcounts": (
        f"""{TERRAIN} {SIGHT} {REACH} {PHYSICS} {TELESCOPE} PLANES BORESIGHT_AZIMUTH
        BORESIGHT_ELEVATION ROLL DAYS MUONS SIGMA CONTRAST MERGE EFFICIENCY STATISTICS
        RAYS_PER_BAR TERRAIN_ERROR TERRAIN_CORRELATION POINTING_ERROR""",
        """COUNTS EXPOSURE RELATIVE_ERROR DENSITY_RESOLUTION CONTRAST_DAYS OPEN_SKY_COUNTS FLUX
        THICKNESS ROCK_SHARE ACCEPTANCE THICKNESS_ERROR TABLE PANEL REPORT""",
        """TOTAL_RATE ROCK_RATE MEDIAN_COUNTS MEDIAN_EXPOSURE MEDIAN_DENSITY_RESOLUTION
        MEDIAN_CONTRAST_DAYS TRAJECTORIES ROCK_TRAJECTORIES UNKNOWN_TRAJECTORIES BORESIGHT_AZIMUTH
        BORESIGHT_ELEVATION DETECTOR_ELEVATION TARGET_DISTANCE QUADRATURE_ERROR""",
    ),
    "radiographyatsites": (
        f"""{TERRAIN} SITES NAME_FIELD DETECTOR_HEIGHT HEIGHT_FIELD TARGET TARGET_HEIGHT QUANTITIES
        {APERTURE} {REACH} {PHYSICS} {PIXEL} WORKERS""",
        "FOLDER INDEX",
        "SITES_DONE SITES_SKIPPED MUOGRAMS MAX_THICKNESS MEDIAN_EXPOSURE UNKNOWN_PIXELS",
    ),
    "tomography": (
        f"""MUOGRAMS ERRORS ACCEPTANCES {TERRAIN} {RECONSTRUCTION} MEAN_DEVIATION STATION_ERROR
        FLUX_ERROR POINTING_ERROR TERRAIN_ERROR TERRAIN_LENGTH SECTION_LINE""",
        """DENSITY COVERAGE DENSITY_ERROR POINTS RESIDUALS STATION_FACTORS RESIDUAL_MUOGRAMS SECTION
        PANEL REPORT""",
        """RESIDUAL CHI_SQUARED ITERATIONS_DONE MEAN_DENSITY REFERENCE RAYS VOXELS_SEEN
        VOXELS_UNSEEN""",
    ),
    "reconstructiontest": (
        f"""{TERRAIN} TARGET TARGET_HEIGHT SITES NAME_FIELD DETECTOR_HEIGHT HEIGHT_FIELD RING_SITES
        RING_RADIUS RING_FROM RING_TO RING_TOLERANCE RING_SLOPE RING_VIEW MODEL ROCK_DENSITY
        BODY_DENSITY BODY_RADIUS BODY_EDGE BODY_POSITION BODY_BASE BODY_TOP BODY_MIDDLE POLYGONS
        {APERTURE} DAYS ACCEPTANCE {TELESCOPE} NOISE MINIMUM_COUNTS SEED MATERIAL {FLUX}
        {RECONSTRUCTION} MEAN_DEVIATION STATION_ERROR FLUX_ERROR POINTING_ERROR TERRAIN_ERROR
        TERRAIN_LENGTH EFFICIENCY DRAWS""",
        """DENSITY COVERAGE DENSITY_ERROR POINTS RESIDUALS TRUTH STATIONS TABLE PANEL REPORT""",
        """CONTRAST RELATIVE_L2 SPREAD BIAS TOP_ERROR TOP_SIGMA FRONT_ERROR FRONT_SIGMA SIDE_ERROR
        SIDE_SIGMA MUONS_COUNTED SITES_USED RAYS VOXELS_SEEN VOXELS_UNSEEN RESIDUAL CHI_SQUARED
        ITERATIONS_DONE SIGNIFICANCE SIGNIFICANCE_OVERALL SURVEYS_SEEING FALSE_ALARMS
        CONTRAST_SPREAD PLACE_ERROR""",
    ),
    "reconstructionbenchmark": (
        "SIZE ANGLES METHODS NOISE ITERATIONS RELAXATION REGULARIZATION SEED",
        "TABLE PANEL REPORT",
        "BEST_METHOD BEST_ERROR BEST_SECONDS GREY_ERROR MATRIX_SECONDS",
    ),
    "siteselection": (
        f"""{TERRAIN} TARGET TARGET_HEIGHT DETECTOR_HEIGHT MIN_DISTANCE MAX_DISTANCE SPACING
        MAX_SLOPE ABOVE_TARGET BELOW_TARGET ROADS ROAD_DISTANCE MASK CANDIDATES TARGET_RADIUS
        TARGET_DEPTH MINIMUM_THICKNESS MAXIMUM_THICKNESS DAYS SITES_WANTED SITES_APART TELESCOPES
        COVERED_ANGLE {APERTURE} {REACH} {PHYSICS} {PIXEL} WORKERS SCHEDULER""",
        """SCORE EXPOSURE SHARE_SEEN THICKNESS SMALLEST_THICKNESS LARGEST_THICKNESS FREE_SKY
        BEST_SITES TELESCOPE_SITES PANEL REPORT""",
        "CANDIDATES_DONE CANDIDATES_SEEING BEST_SCORE BEST_EXPOSURE BEST_SHARE_SEEN COVERAGE",
    ),
    "fluxspectrum": (
        """FLUX_MODELS ZENITH_ANGLES THICKNESS MATERIAL DENSITY GAISSER_PARAMETERS ENERGY_LOSS
        STRAGGLING ALTITUDE_CORRECTION DETECTION_THRESHOLD ALTITUDE MATERIALS""",
        "TABLE FLUX_TABLE ENERGY_LOSS_TABLE MINIMUM_ENERGY_TABLE PANEL REPORT",
        "OPACITY MINIMUM_ENERGY LARGEST_RATIO",
    ),
    "downloadsrtm": (
        """EXTENT MARGIN SOURCE FILL_VOIDS FILL_DISTANCE MAX_TILES AUTHCFG TIMEOUT RETRIES CACHE""",
        "DEM",
        "TILES CACHED_TILES SEA_TILES VOID_PIXELS FILLED_PIXELS",
    ),
    "volcanosurvey": (
        f"""DEM BAND {SIGHT} {APERTURE} MATERIAL DENSITY FLUX_MODEL ACCEPTANCE MUONS""",
        """radiography:THICKNESS radiography:FLUX radiography:EXPOSURE radiography:FIELD_OF_VIEW
        radiography:REPORT thickness:OUTPUT flux:OUTPUT""",
        "",
    ),
    "exposureplan": (
        f"DEM BAND {SIGHT} PRESET DAYS MUONS SIGMA CONTRAST MERGE MATERIAL DENSITY FLUX_MODEL",
        """telescope:COUNTS telescope:DENSITY_RESOLUTION telescope:EXPOSURE telescope:REPORT
        telescope:TABLE exposure:OUTPUT contrast:OUTPUT""",
        "",
    ),
}  # fmt: skip


def missing(names, declared):
    return set(names.split()) - set(declared)


@pytest.mark.parametrize("algorithm", INTERFACE)
def test_no_name_of_an_algorithm_is_gone(algorithm, declared_by, root):
    declared = declared_by(root)[f"muysc:{algorithm}"]
    parameters, files, numbers = INTERFACE[algorithm]
    assert missing(parameters, declared["parameters"]) == set()
    assert missing(files, declared["files"]) == set()
    assert missing(numbers, set(declared["outputs"]) - set(declared["files"])) == set()


def test_no_word_of_a_choice_is_gone(declared_by, root):
    algorithms = declared_by(root)
    found = {
        (algorithm, parameter): missing(WORDS[parameter], words)
        for algorithm, names in algorithms.items()
        for parameter, words in names["words"].items()
        if parameter in WORDS
    }
    assert {parameter for _, parameter in found} == set(WORDS)
    assert {place: gone for place, gone in found.items() if gone} == {}


def test_a_new_name_is_written_down_here(declared_by, root):
    known = {
        f"muysc:{algorithm}": set(" ".join(names).split()) for algorithm, names in INTERFACE.items()
    }
    for algorithm, names in declared_by(root).items():
        assert {*names["parameters"], *names["outputs"]} <= known.get(algorithm, set()), algorithm
        assert names["words"].keys() <= WORDS.keys(), algorithm


def test_the_provider_keeps_its_name(provider):
    assert (provider.id(), provider.name()) == ("muysc", "MUYSC")


def keys_of(path):
    return set(gdal.Open(str(path)).GetMetadata("MUYSC"))


def test_no_key_of_a_muogram_is_gone(data_folder, tmp_path):
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    sight = take_sight(dem, (14.410686, 40.810561), (14.424745, 40.823729))
    simulation = simulate(sight, Aperture(20.0, 10.0, 2, 2), Physics(), Telescope(6.0))
    assert simulation.muograms.keys() >= UNITS.keys() - {"counts", "density"}
    for name, muogram in simulation.muograms.items():
        write_muogram(muogram, tmp_path / f"{name}.tif")
        assert keys_of(tmp_path / f"{name}.tif") == set(MUOGRAM.split()), name


def test_no_key_of_a_muogram_on_another_datum_is_gone(data_folder, tmp_path):
    dem = open_dem(data_folder / "st_helens_usgs.tif")
    sight = take_sight(dem, (561_816.0, 5_114_156.0), (562_260.0, 5_115_390.0))
    simulation = simulate(sight, Aperture(20.0, 10.0, 2, 2), Physics(), Telescope(6.0))
    write_muogram(simulation.muograms["flux"], tmp_path / "flux.tif")
    assert keys_of(tmp_path / "flux.tif") == {*MUOGRAM.split(), *OTHER_DATUM.split()}


def test_no_key_of_a_raster_in_telescope_angles_is_gone(tmp_path):
    collected = trajectories(TelescopeGeometry(2, 2, 5.0, 100.0), "exact")
    for name, one in maps_of(collected, "two bars").items():
        write_trajectories(one, tmp_path / f"{name}.tif")
        assert keys_of(tmp_path / f"{name}.tif") == set(TELESCOPE_ANGLES.split()), name


def test_quantities_keep_their_names_and_units():
    assert {name: QUANTITIES[name].unit for name in UNITS} == UNITS

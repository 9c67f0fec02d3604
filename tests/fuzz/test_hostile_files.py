"""Files with bytes flipped, cut and blanked, and rasters with absurd metadata."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.volume import Volume, read_volume, write_volume
from tools.fuzzing.mutations import claims, edits, misstate, mutate
from tools.fuzzing.scene import FOOT, MIDDLE
from tools.fuzzing.verdict import about_sentence

SIGHT = {"DETECTOR": FOOT, "TARGET": MIDDLE, "ELEVATION_APERTURE": 16, "AZIMUTH_PIXELS": 6,
         "ELEVATION_PIXELS": 5}  # fmt: skip
RASTERS = {"THICKNESS": "*t.tif", "FLUX": "*f.tif"}


#: How a raster is changed: its bytes, or what it says of itself.
CHANGES = st.one_of(st.tuples(st.just(mutate), edits), st.tuples(st.just(misstate), claims))


@pytest.fixture
def with_bytes_changed(tmp_path, explore, attempt):
    """Try an algorithm on files with their bytes changed."""

    def try_files(sources, parameters_of, name=None):
        def case(drawn):
            source, changes = drawn
            target = tmp_path / (name or Path(source).name)
            mutate(Path(source), target, changes)
            attempt(*parameters_of(str(target)))

        explore(st.tuples(st.sampled_from(sources), edits), case)

    return try_files


def _radiography(dem):
    return "radiography", {"DEM": dem, **SIGHT, **RASTERS}


def test_terrain_in_geotiff(with_bytes_changed, scene):
    with_bytes_changed([*scene.dems, *scene.odd_dems], _radiography)


def test_terrain_that_claims_absurd_things(tmp_path, explore, attempt, scene):
    def case(drawn):
        source, claim = drawn
        misstate(Path(source), tmp_path / "dem.tif", claim)
        attempt(*_radiography(str(tmp_path / "dem.tif")))

    explore(st.tuples(st.sampled_from(scene.dems), claims), case)


def test_terrain_in_hgt(with_bytes_changed, scene):
    with_bytes_changed([scene.tile], _radiography, name="N40E014.hgt")


def test_tiles_to_download(with_bytes_changed, scene):
    def download(tile):
        return "downloadsrtm", {
            "EXTENT": "14.41,14.43,40.81,40.83 [EPSG:4326]", "CACHE": "*cache", "DEM": "*dem.tif",
            "SOURCE": f"file://{Path(tile).parent}/{{tile}}.hgt.gz",
        }  # fmt: skip

    with_bytes_changed([scene.packed_tile], download)


TABLE = {"QUANTITY": "flux", "OUTPUT": "*m.tif"}
ANGLES = {"AZIMUTH_FIRST": 0, "AZIMUTH_LAST": 20, "VERTICAL_FIRST": 60, "VERTICAL_LAST": 80}


@pytest.mark.parametrize("layout", ["auto", "table", "matrix"])
def test_text_tables(with_bytes_changed, scene, layout):
    angles = {} if layout == "table" else ANGLES
    more = {**TABLE, **angles, "VERTICAL_ANGLE": "zenith", "LAYOUT": layout}
    with_bytes_changed(
        [*scene.tables, *scene.odd_files],
        lambda table: ("importmuogram", {"INPUT": table, **more}),
    )


def test_matrices_of_errors(with_bytes_changed, scene):
    matrix = next(path for path in scene.tables if path.endswith("matrix.txt"))
    more = {**TABLE, **ANGLES, "VERTICAL_ANGLE": "zenith", "INPUT": matrix, "ERROR": "*e.tif"}
    with_bytes_changed(
        [matrix, *scene.odd_files],
        lambda errors: ("importmuogram", {**more, "ERROR_INPUT": errors}),
    )


#: Algorithms, the parameter that takes a layer, its kind, and the other parameters.
LAYERS = [
    ("radiographyatsites", "SITES", "points", {"FOLDER": "*folder"}),
    ("siteselection", "ROADS", "lines", {"SCORE": "*score.tif"}),
    ("siteselection", "CANDIDATES", "points", {"SCORE": "*score.tif"}),
    ("reconstructiontest", "SITES", "points", {"DENSITY": "*d.tif", "STATIONS": "*s.gpkg"}),
    ("reconstructiontest", "POLYGONS", "polygons", {"MODEL": "polygons", "DENSITY": "*d.tif"}),
    ("tomography", "SECTION_LINE", "lines", {"DENSITY": "*d.tif", "SECTION": "*s.png"}),
]


@pytest.mark.parametrize(
    ("algorithm", "parameter", "kind", "others"), LAYERS, ids=[f"{a}-{p}" for a, p, *_ in LAYERS]
)
def test_layers(with_bytes_changed, fuzz_client, scene, algorithm, parameter, kind, others):
    declared = {one["name"] for one in fuzz_client.catalogue[algorithm]}
    given = {
        "DEM": scene.dems[0], "MUOGRAMS": scene.muograms["thickness"][:2], "VOXELS": 8,
        "SPACING": 400, "MAX_DISTANCE": 1600, **SIGHT,
    }  # fmt: skip
    fixed = {name: value for name, value in given.items() if name in declared} | others
    with_bytes_changed(scene.layers[kind], lambda layer: (algorithm, {**fixed, parameter: layer}))


VOLUME = {
    "DEM": "dem", "EXTENT": "451000,452000,4518400,4519400 [EPSG:32633]", "VOXELS": 8,
    "DENSITY": "*d.tif", "REPORT": "*r.html",
}  # fmt: skip
COUNTED = {"THICKNESS": "in tangents", "DENSITY": "*d.tif", "PANEL": "*p.png"}
#: Algorithms, the parameter that takes a muogram, its quantity, and the other parameters.
USES = [
    ("muonflux", "THICKNESS", "thickness", {"FLUX": "*f.tif", "PANEL": "*p.png"}),
    ("muonflux", "OPACITY", "opacity", {"FLUX": "*f.tif"}),
    ("drape", "MUOGRAM", "thickness", {"DEM": "dem", "OUTPUT": "*o.tif"}),
    ("importmuogram", "REFERENCE", "thickness", {"INPUT": "table", "OUTPUT": "*m.tif"}),
    ("density", "THICKNESS", "thickness", {"TRANSMISSION": "transmission", "DENSITY": "*d.tif"}),
    ("density", "TRANSMISSION", "transmission", {"THICKNESS": "thickness", "DENSITY": "*d.tif"}),
    ("density", "FLUX", "flux", {"THICKNESS": "thickness", "DENSITY": "*d.tif"}),
    ("density", "ERROR", "flux_error", {
        "FLUX": "flux", "THICKNESS": "thickness", "DENSITY": "*d.tif", "REPORT": "*r.html",
    }),
    ("density", "COUNTS", "counts", {**COUNTED, "ACCEPTANCE": 5}),
    ("density", "ACCEPTANCES", "acceptance", {**COUNTED, "COUNTS": "counts"}),
    ("density", "OPEN_SKY_COUNTS", "open_sky_counts", {**COUNTED, "COUNTS": "counts"}),
    ("tomography", "MUOGRAMS", "thickness", VOLUME),
    ("tomography", "ERRORS", "thickness_error", {**VOLUME, "MUOGRAMS": "thickness"}),
]  # fmt: skip


@pytest.mark.parametrize(
    ("algorithm", "parameter", "quantity", "others"), USES, ids=[f"{a}-{p}" for a, p, *_ in USES]
)
def test_muograms(tmp_path, explore, attempt, scene, algorithm, parameter, quantity, others):
    files = {
        "dem": scene.dems[0],
        "table": scene.tables[0],
        "in tangents": scene.muograms["thickness"][2],
        **{
            name: scene.muograms[name][0]
            for name in ("thickness", "transmission", "flux", "counts")
        },
    }
    others = {name: files.get(value, value) for name, value in others.items()}
    source = Path(scene.muograms[quantity][0])
    target = tmp_path / source.name

    def case(drawn):
        change, how = drawn
        change(source, target, how)
        attempt(algorithm, {**others, parameter: str(target)})

    explore(CHANGES, case)


def test_volumes(tmp_path, explore):
    def case(drawn):
        change, how = drawn
        change(tmp_path / "volume.tif", tmp_path / "changed.tif", how)
        said = ""
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                read_volume(tmp_path / "changed.tif")
            except MuyscError as error:
                said = str(error)
        assert not said or not about_sentence(said), f"FAULTS: {said}"

    grid = VoxelGrid((451_000.0, 4_518_400.0, 0.0), (100.0, 100.0, 50.0), (9, 8, 7))
    values = np.full(grid.shape, 2.5)
    write_volume(Volume("density", grid, values, "EPSG:32633"), tmp_path / "volume.tif")
    explore(CHANGES, case)

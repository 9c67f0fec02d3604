"""The rules of the architecture: who may import what."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
LIBRARY = ROOT / "muysc_qgis"
ALGORITHMS = ROOT / "processing_algorithms"

#: Libraries by room; the longest path that fits a file counts.
ROOMS = {
    "muysc_qgis/radiography": {"numpy", "scipy"},
    "muysc_qgis/measurement": {"numpy", "scipy"},
    "muysc_qgis/telescope": {"numpy", "scipy"},
    "muysc_qgis/forward": {"numpy"},
    "muysc_qgis/tomography": {"numpy", "scipy"},
    "muysc_qgis/survey": {"numpy", "osgeo", "pyproj", "distributed"},
    "muysc_qgis/topography": {"numpy", "scipy", "osgeo", "pyproj"},
    "muysc_qgis/plots": {"numpy", "scipy", "osgeo", "pyproj", "matplotlib", "jinja2"},
    "muysc_qgis/plugin.py": {"qgis"},
    "muysc_qgis/translation.py": {"qgis"},
    # The package processing is a part of QGIS.
    "muysc_qgis/gui": {"numpy", "qgis", "processing", "matplotlib"},
    "muysc_qgis": {"numpy", "scipy", "osgeo", "pyproj"},
    "processing_algorithms": {"numpy", "osgeo", "qgis"},
}
#: Modules of the library, outside the desktop, that need QGIS.
USES_QGIS = ("plugin.py", "translation.py")
#: What every room may import of the project itself.
_COMMON = {"errors", "progress", "quantities", "__version__"}
#: Beside the rooms: the forms of data, and their files.
_DATA = {"muogram", "trajectories", "views", "volume", "tables"}
_COMPUTING = {
    "radiography", "telescope", "forward", "topography", "survey", "measurement", "tomography",
}  # fmt: skip
#: And what these may: rock and muons know no terrain, no file and no picture; terrain,
#: telescopes and measurements know neither each other nor a picture; only the desktop
#: knows the desktop.
NEIGHBOURS = {
    "muysc_qgis/radiography": _COMMON | {"radiography"},
    "muysc_qgis/telescope": _COMMON | {"telescope", "radiography"},
    "muysc_qgis/topography": _COMMON | {"topography", "radiography", "muogram", "geotiff"},
    "muysc_qgis/survey": _COMMON | {"survey", "topography"},
    "muysc_qgis/forward": _COMMON | {"forward", "radiography", "telescope"},
    "muysc_qgis/measurement": _COMMON | {"measurement", "forward", "radiography", "muogram"},
    "muysc_qgis/tomography": _COMMON | {"tomography"},
    "muysc_qgis/workflows": _COMMON | _DATA | _COMPUTING | {"workflows"},
    "muysc_qgis/plots": _COMMON | _DATA | _COMPUTING | {"workflows", "plots"},
}
#: The only libraries that loading the plugin may load.
LIGHT = {"numpy"}

FILES = sorted([*LIBRARY.rglob("*.py"), *ALGORITHMS.rglob("*.py"), ROOT / "__init__.py"])
SHIPPED = pytest.mark.parametrize(
    "file", FILES, ids=[str(file.relative_to(ROOT)) for file in FILES]
)


def tree_of(file):
    return ast.parse(file.read_text(encoding="utf-8"))


def absolute_imports(tree):
    """Yield the modules imported by their full name, but for those of annotations."""
    for_types = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        for line in node.body
        for inner in ast.walk(line)
    }
    for node in ast.walk(tree):
        if id(node) in for_types:
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def relative_targets(file, tree):
    """Yield what a file of the library imports of it, as parts below muysc_qgis."""
    here = file.relative_to(ROOT).parent.parts
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = here[: len(here) - node.level + 1]
            path = (*base, *(node.module or "").split("."))
            path = tuple(part for part in path if part)
            for alias in node.names:
                yield (*path, alias.name)


def room_of(file, rooms):
    relative = file.relative_to(ROOT)
    fits = [room for room in rooms if Path(room) in (relative, *relative.parents)]
    return max(fits, key=len, default=None)


def foreign(modules):
    return {
        top
        for top in (module.split(".")[0] for module in modules)
        if top not in sys.stdlib_module_names
    }


def at_load(tree):
    """Yield the statements that run when a module is loaded, outside functions."""
    pending = [*tree.body]
    while pending:
        node = pending.pop()
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        if isinstance(node, (ast.If, ast.Try, ast.With, ast.ClassDef)):
            pending += node.body
            pending += getattr(node, "orelse", [])
            pending += [line for one in getattr(node, "handlers", []) for line in one.body]
        yield node


@SHIPPED
def test_a_room_uses_only_its_libraries(file):
    room = room_of(file, ROOMS)
    allowed = ROOMS[room] if room else set()
    assert foreign(absolute_imports(tree_of(file))) <= allowed


@SHIPPED
def test_a_room_knows_only_its_neighbours(file):
    room = room_of(file, NEIGHBOURS)
    if room is None:
        # The library never reaches up to the algorithms; the entry point and the desktop do.
        desktop = file.name == "plugin.py" or "gui" in file.parts
        above = set() if desktop else {"processing_algorithms"}
        if LIBRARY in file.parents:
            assert not {path[0] for path in relative_targets(file, tree_of(file))} & above
        return
    for path in relative_targets(file, tree_of(file)):
        assert path[0] == "muysc_qgis"
        assert path[1] in NEIGHBOURS[room], f"{'.'.join(path)}"


@SHIPPED
def test_the_plugin_imports_itself_relatively(file):
    names = {module.split(".")[0] for module in absolute_imports(tree_of(file))}
    assert not names & {"muysc_qgis", "processing_algorithms", "muysc", ROOT.name}


@SHIPPED
def test_qt_comes_through_qgis_and_figures_never_through_pyplot(file):
    modules = set(absolute_imports(tree_of(file)))
    assert not foreign(modules) & {"PyQt5", "PyQt6", "PySide2", "PySide6"}
    assert "matplotlib.pyplot" not in modules


@SHIPPED
def test_the_library_loads_nothing_heavy(file):
    if LIBRARY not in file.parents or room_of(file, ROOMS).endswith((*USES_QGIS, "gui")):
        return
    nodes = [
        node for node in at_load(tree_of(file)) if isinstance(node, (ast.Import, ast.ImportFrom))
    ]
    loaded = foreign(absolute_imports(ast.Module(body=nodes, type_ignores=[])))
    assert loaded <= LIGHT


@SHIPPED
def test_nothing_touches_the_search_path_or_prints(file):
    for node in ast.walk(tree_of(file)):
        if isinstance(node, ast.Attribute):
            assert ast.unparse(node) != "sys.path"
        if isinstance(node, ast.Call):
            assert ast.unparse(node.func) != "print"


def test_loading_every_module_of_the_library_loads_only_numpy():
    """What the rule above is for, transitively and in one process."""
    modules = [
        ".".join(file.relative_to(ROOT).with_suffix("").parts)
        for file in LIBRARY.rglob("*.py")
        if file.name not in (*USES_QGIS, "__init__.py") and "gui" not in file.parts
    ]
    code = (
        "import importlib, sys\n"
        f"for name in {modules!r}: importlib.import_module(name)\n"
        "print(*{'scipy', 'matplotlib', 'jinja2', 'osgeo', 'pyproj', 'qgis'} & {*sys.modules})"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == []


def test_no_file_is_longer_than_400_lines(tracked):
    lengths = {
        str(name): len((ROOT / name).read_text(encoding="utf-8").splitlines())
        for name in tracked
        if name.suffix == ".py"
    }
    assert lengths
    assert {name: length for name, length in lengths.items() if length > 400} == {}


def test_files_of_tests_have_names_of_their_own(tracked):
    names = [path.name for path in tracked if path.match("tests/*/test_*.py")]
    assert len(names) > 50
    assert sorted(names) == sorted(set(names))


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ("import scipy.fft", {"scipy"}),
        ("def late():\n    from osgeo import gdal", {"osgeo"}),
        ("from . import errors\nimport math", set()),
        ("if TYPE_CHECKING:\n    import jinja2\nelse:\n    import osgeo", {"osgeo"}),
    ],
)
def test_the_reader_of_imports_sees_them(code, found):
    assert foreign(absolute_imports(ast.parse(code))) == found

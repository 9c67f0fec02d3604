"""From what the algorithms declare to values: sound ones, and everything else."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from hypothesis import strategies as st

from .scene import FOOT, MIDDLE, Scene

Declared = dict[str, Any]
Values = st.SearchStrategy[Any]

#: Sound whole numbers are small, so that a case takes little time.
_SMALL = 12
#: Quantities that a raster parameter takes, where its name does not say so.
_TAKEN = {
    "counts": ("counts",),
    "muogram": ("thickness", "flux"),
    "muograms": ("thickness", "opacity", "flux", "transmission"),
    "reference": ("thickness",),
    "acceptances": ("acceptance",),
    "error": ("transmission_error",),
    "errors": ("thickness_error",),
}
#: Layers that an algorithm takes together, where it does not take any two.
_TOGETHER: dict[str, list[set[str]]] = {
    "muonflux": [{"THICKNESS"}, {"OPACITY"}],
    "density": [
        {"TRANSMISSION"}, {"FLUX"}, {"TRANSMISSION", "ERROR"}, {"COUNTS"},
        {"COUNTS", "ACCEPTANCES"}, {"COUNTS", "OPEN_SKY_COUNTS"},
    ],
}  # fmt: skip
#: What also takes rasters in telescope angles, as the last detector of the scene has them.
_OF_TELESCOPES = ("density", "drape")
#: Where sound numbers of the scene lie, if the algorithm does not say so.
_SPANS = {
    "VOXEL_SIZE": (100, 400), "BASE": (0, 200), "TOP": (400, 900), "MAX_RANGE": (500, 9000),
    "BODY_BASE": (0, 200), "BODY_TOP": (300, 700), "BODY_MIDDLE": (100, 400),
    "AZIMUTH_FIRST": (0, 20), "AZIMUTH_LAST": (30, 60), "VERTICAL_FIRST": (50, 60),
    "VERTICAL_LAST": (65, 85),
    "VOXELS": (6, 16),
}  # fmt: skip
#: What no parameter expects.
_JUNK = st.sampled_from(
    ["", " ", "nan", "none", "<b>", "-1", "1e999", "0x10", "１２", "é\u202e", "\0", "a" * 5000,
     "'; --", "/", "..", "{tile}", None, True, 10**30, -(10**30), float("nan"), float("inf"), [],
     {}]
)  # fmt: skip
_NUMBERS = st.one_of(
    st.sampled_from([0, -0.0, -1, 1, 1e-300, 5e-324, 1e-9, 0.5, 1e6, 1e9, 2**31, 2**63, 1e300]),
    st.floats(-1e3, 1e3),
    st.floats(),
)
_POINTS = st.sampled_from(
    [FOOT, MIDDLE, "14.425,40.8205", "451500,4518900", "451500,4518900 [EPSG:32633]",
     "14.4451,40.84 [EPSG:4326]", "0,0 [EPSG:4326]", "1e300,1e300 [EPSG:4326]",
     "nan,nan [EPSG:4326]", "inf,0 [EPSG:4326]", "14.4,40.8 [EPSG:999999]", "14.4,40.8 [x]",
     "14.4", "14.4,40.8,3", "POINT(14.4 40.8)", "180,90 [EPSG:4326]"]
)  # fmt: skip
_EXTENT = "451000,452000,4518400,4519400 [EPSG:32633]"
_EXTENTS = st.sampled_from(
    [_EXTENT, "14.41,14.44,40.81,40.83", "14.41,14.44,40.81,40.83 [EPSG:4326]",
     "14.44,14.41,40.83,40.81 [EPSG:4326]", "14.4,14.4,40.8,40.8 [EPSG:4326]",
     "-180,180,-90,90 [EPSG:4326]", "nan,nan,nan,nan [EPSG:4326]", "0,1e300,0,1e300 [EPSG:3857]",
     "179,181,-1,1 [EPSG:4326]", "1,2,3", "0,1,89,91 [EPSG:4326]"]
)  # fmt: skip
#: Whether something optional is given.
_GIVEN = st.sampled_from([False, False, True])
#: Nothing that leads off this machine.
_TEXTS = st.one_of(
    st.sampled_from(
        ["1", "0", "-1", "azimuth", "counts", "http://127.0.0.1:1/{tile}.hgt",
         "file:///nowhere/{tile}.hgt", "file:///proc/self/mem", "ftp://127.0.0.1:1/{tile}",
         "http://[", "tcp://127.0.0.1:1", "127.0.0.1:1", "0, 30, 60", "0,0,0", "nan", "90", "89.9",
         "1e999", ",,,", "1;2", "{", "{tile}"]
    ),
    st.text(st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"]), max_size=20),
)  # fmt: skip


def _mostly(usual: Values, rare: Values, out_of: int) -> Values:
    """Return what is rare once out of so many times; `one_of` takes no shares."""
    return st.integers(1, out_of).flatmap(lambda number: rare if number == out_of else usual)


def _rasters(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    name = declared["name"].lower()
    quantities = _TAKEN.get(name, (name,))
    fitting = [path for one in quantities for path in scene.seen.get(one, [])]
    muograms = [path for paths in scene.muograms.values() for path in paths]
    everything = [*scene.dems, *scene.odd_dems, *muograms, *scene.odd_files]
    odd = scene.odd_dems if "dem" in name or name == "mask" else muograms
    sound = fitting or ([None] if declared["optional"] else scene.dems)
    return (
        st.sampled_from(sound),
        st.one_of(st.sampled_from(odd), st.sampled_from(everything), _JUNK),
    )


def _several(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    # Seen from several places, unlike single ones.
    sound = st.sampled_from([scene.muograms[one] for one in _TAKEN[declared["name"].lower()]])
    one, odd = _rasters(declared, scene)
    return sound, st.one_of(sound, st.lists(st.one_of(one, odd), max_size=4), odd)


def _numbers(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    low, high, default = declared["low"], declared["high"], declared["default"]
    sound, span = st.just(default), _SPANS.get(declared["name"])
    if declared["whole"]:
        least = max(int(low), 0) if low > -1e9 else 0
        plain = st.integers(least, max(least, min(_SMALL, int(min(high, _SMALL)))))
        edges = [int(low) - 1, int(low), int(low) + 1]
        edges += [int(high) - 1, int(high), int(high) + 1] if high < 1e9 else []
        odd: Values = st.one_of(plain, st.sampled_from([*edges, 2**31 - 1, 2**31, 1.5]))
        sound = sound if default is not None and default <= _SMALL else plain
        sound = st.integers(*span) if span else sound
    else:
        edges = [edge for edge in (low, high) if abs(edge) < 1e300]
        within = st.floats(edges[0], edges[-1]) if len(edges) == 2 else st.floats(0, 1e4)
        odd = st.one_of(within, st.sampled_from([*edges, 0.0]))
        if default is None:
            sound = st.floats(*span) if span else within if len(edges) == 2 else st.floats(1, 100)
    return sound, st.one_of(odd, _NUMBERS, _NUMBERS.map(str), _JUNK)


def _words(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    options = st.sampled_from(declared["options"])
    if declared["several"]:
        return st.just(declared["default"]), st.one_of(st.lists(options, max_size=4), _JUNK)
    return (
        _mostly(st.just(declared["default"]), options, 3),
        st.one_of(options, st.integers(-1, 99), _JUNK),
    )


def _fields(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    sound = "height" if declared["name"].startswith("HEIGHT") else "name"
    return st.just(sound), st.one_of(st.sampled_from(["name", "height", "fid", "nothing"]), _JUNK)


def _layers(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    name = declared["name"].lower()
    kind = "polygons" if "polygon" in name else "points" if "site" in name else "lines"
    kind = "points" if "candidates" in name else kind
    everything = [path for paths in scene.layers.values() for path in paths]
    return (
        st.just(scene.layers[kind][0]),
        st.one_of(
            st.sampled_from(scene.layers[kind]),
            st.sampled_from([*everything, *scene.odd_files, scene.dems[0]]),
            _JUNK,
        ),
    )


def _files(declared: Declared, scene: Scene) -> tuple[Values, Values]:
    if declared["folder"]:
        # Where the algorithm may write: nowhere but in the case's own folder.
        return st.just("*cache"), st.sampled_from(["*cache", "*cache/deep/er", *scene.odd_files])
    return (
        st.sampled_from(scene.tables),
        st.one_of(st.sampled_from([*scene.odd_files, *scene.dems]), _JUNK),
    )


def _fixed(sound: Any, odd: Values) -> Callable[[Declared, Scene], tuple[Values, Values]]:
    return lambda declared, scene: (st.just(sound), st.one_of(odd, _JUNK))


_DEFAULT = object()
#: Sound and other values by the type of the parameter.
_KINDS: dict[str, Callable[[Declared, Scene], tuple[Values, Values]]] = {
    "raster": _rasters,
    "multilayer": _several,
    "number": _numbers,
    "distance": _numbers,
    "enum": _words,
    "source": _layers,
    "vector": _layers,
    "file": _files,
    "boolean": lambda declared, scene: (st.booleans(), st.one_of(st.booleans(), _JUNK)),
    "band": _fixed(1, st.integers(-1, 3)),
    "point": _fixed(FOOT, _POINTS),
    "extent": _fixed(_EXTENT, _EXTENTS),
    "string": _fixed(_DEFAULT, _TEXTS),
    "authcfg": _fixed(None, _TEXTS),
    "field": _fields,
    "crs": _fixed("EPSG:32633", st.sampled_from(["EPSG:4326", "EPSG:4978", "EPSG:3031", "EPSG:0"])),
}
_LAYERS = ("raster", "multilayer", "source", "vector")
#: Endings by the type of a destination; * stands for the case's own folder.
_ENDINGS = {
    "rasterDestination": ".tif", "sink": ".gpkg", "vectorDestination": ".csv",
    "folderDestination": "", "fileDestination": "",
}  # fmt: skip
_BAD_PLACES = ("*missing/deep/", "/proc/version/", "/dev/null/", "*ä ö/")


def destination(declared: Declared) -> Values:
    """Return where an output may go."""
    ending = _ENDINGS[declared["type"]]
    if declared["type"] == "fileDestination":
        ending = declared["filter"].partition("*")[2].partition(")")[0].partition(" ")[0]
    # QGIS takes what is before a colon for the name of a provider.
    name = declared["name"].lower().replace(":", "_") + ending
    return _mostly(
        st.just(f"*{name}"), st.sampled_from([f"{place}{name}" for place in _BAD_PLACES]), 20
    )


@st.composite
def parameters(
    draw: st.DrawFn, algorithm: str, declared: list[Declared], scene: Scene
) -> dict[str, Any]:
    """Draw sound parameters of an algorithm, then let a few be anything."""
    # What is sound together was seen from one place.
    seen = scene.seen_from(draw(st.integers(0, 2 if algorithm in _OF_TELESCOPES else 1)))
    inputs = [one for one in declared if one["type"] not in _ENDINGS]
    names = st.sampled_from([one["name"] for one in inputs])
    odd = draw(st.sets(names, max_size=draw(st.sampled_from([0, 1, 1, 4]))))
    drawn = {}
    for one in inputs:
        sound, anything = _KINDS[one["type"]](one, seen)
        if one["name"] in odd:
            drawn[one["name"]] = draw(anything)
            continue
        given = not one["optional"] or one["type"] in _LAYERS or draw(_GIVEN)
        value = draw(sound) if given else one["default"]
        value = scene.sound.get(one["name"], value)
        if value is not _DEFAULT and value is not None:
            drawn[one["name"]] = value
    # Some of what is optional excludes the rest.
    layers = {one["name"] for one in inputs if one["optional"] and one["type"] in _LAYERS}
    asked = draw(_layers_asked(algorithm, layers & {*drawn}))
    drawn = {name: value for name, value in drawn.items()
             if name not in layers or name in asked or name in odd}  # fmt: skip
    files = [value for value in drawn.values()
             if isinstance(value, str) and value.startswith(str(scene.folder))]  # fmt: skip
    drawn |= draw(_destinations([one for one in declared if one["type"] in _ENDINGS], files))
    if draw(st.integers(0, 30)) == 30:
        drawn["NO_SUCH_PARAMETER"] = 1
    return drawn


def _layers_asked(algorithm: str, layers: set[str]) -> Values:
    """Return which of some optional layers are given together."""
    together = [group for group in _TOGETHER.get(algorithm, []) if group <= layers]
    if together:
        return st.sampled_from(together)
    return st.sets(st.sampled_from(sorted(layers)), max_size=2) if layers else st.just(set())


@st.composite
def _destinations(draw: st.DrawFn, outputs: list[Declared], inputs: list[str]) -> dict[str, Any]:
    """Draw where outputs go: rarely two to one file, or one onto an input."""
    wanted = draw(st.sets(st.sampled_from([one["name"] for one in outputs]), max_size=4))
    places = {
        one["name"]: draw(destination(one))
        for one in outputs
        if one["name"] in wanted or not one["optional"]
    }
    if places and draw(st.integers(0, 20)) == 20:
        name = draw(st.sampled_from(sorted(places)))
        places[name] = draw(st.sampled_from([*places.values(), *inputs]))
    return places

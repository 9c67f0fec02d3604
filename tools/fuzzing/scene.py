"""The files that cases are made of: terrain, muograms, layers and tables, good and odd."""

from __future__ import annotations

import gzip
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from muysc_qgis.muogram import read_muogram, write_muogram

from .client import Client

#: The mountain's foot and middle (longitude, latitude), where telescopes stand and look.
FOOT = "14.4055,40.8205 [EPSG:4326]"
MIDDLE = "14.425,40.8205 [EPSG:4326]"
_LONGITUDE, _LATITUDE = 14.425, 40.8205
_UTM = (451_500.0, 4_518_900.0)
_CELLS = 48
#: Quantities of which there are errors.
_MEASURED = ("thickness", "flux", "transmission")


@dataclass
class Scene:
    """Names of files by what they are good for."""

    folder: Path
    #: Sound and odd terrain.
    dems: list[str] = field(default_factory=list)
    odd_dems: list[str] = field(default_factory=list)
    #: Muograms by quantity, and rasters in telescope angles.
    muograms: dict[str, list[str]] = field(default_factory=dict)
    #: Those of one detector.
    seen: dict[str, list[str]] = field(default_factory=dict)
    #: Layers by kind: points, lines, polygons.
    layers: dict[str, list[str]] = field(default_factory=dict)
    tables: list[str] = field(default_factory=list)
    odd_files: list[str] = field(default_factory=list)
    #: A tile of SRTM of three arc seconds, and a packed one of one arc second.
    tile: str = ""
    packed_tile: str = ""
    #: Sound values of parameters whose default takes long, or leads to a server.
    sound: dict[str, Any] = field(default_factory=dict)

    def seen_from(self, number: int) -> Scene:
        """Return the scene with the muograms of one detector."""
        own = {
            quantity: [path for path in paths if path.endswith(f"_{number}.tif")]
            for quantity, paths in self.muograms.items()
        }
        return replace(self, seen=own)


def cone(columns: int = _CELLS, rows: int = _CELLS) -> np.ndarray:
    """Return a cone of 600 m on a plain of 100 m, in whole metres."""
    y, x = np.mgrid[-1 : 1 : rows * 1j, -1 : 1 : columns * 1j]
    return np.round(100 + 600 * np.clip(1 - 1.2 * np.hypot(x, y), 0, None))


def write_raster(
    path: Path,
    values: np.ndarray,
    transform: tuple[float, ...],
    crs: str,
    no_data: float | None = None,
    unit: str = "",
    kind: str = "Float32",
) -> str:
    """Write a raster of one band for each of the first axis of `values`."""
    from osgeo import gdal, osr

    gdal.UseExceptions()
    bands = values[None] if values.ndim == 2 else values
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), bands.shape[2], bands.shape[1], len(bands), gdal.GetDataTypeByName(kind)
    )
    dataset.SetGeoTransform(transform)
    if crs:
        reference = osr.SpatialReference()
        reference.SetFromUserInput(crs)
        dataset.SetProjection(reference.ExportToWkt())
    for number, band_values in enumerate(bands, 1):
        band = dataset.GetRasterBand(number)
        if no_data is not None:
            band.SetNoDataValue(no_data)
        band.SetUnitType(unit)
        band.WriteArray(band_values)
        del band
    del dataset
    return str(path)


def _around(x: float, y: float, width: float, height: float, cells: int = _CELLS) -> tuple:
    """Return the geotransform of a square raster around a point."""
    return (x - width / 2, width / cells, 0.0, y + height / 2, 0.0, -height / cells)


def _terrain(folder: Path) -> tuple[list[str], list[str]]:
    """Return sound terrain and odd terrain, all of it around the same place."""
    heights, rng = cone(), np.random.default_rng(1)
    utm, degrees = _around(*_UTM, 4800, 4800), _around(_LONGITUDE, _LATITUDE, 0.057, 0.043)
    turned = (utm[0] - 500, 90.0, 30.0, utm[3] - 900, 30.0, -90.0)
    upward = (utm[0], utm[1], 0.0, utm[3] - 4800, 0.0, -utm[5])
    mercator = _around(1_605_783.0, 4_986_000.0, 6400, 6400)
    holes = np.where(rng.random(heights.shape) < 0.05, -32768, heights)

    def with_one(value: float) -> np.ndarray:
        changed = heights.copy()
        changed[20, 20] = value
        return changed

    def raster(name: str, *arguments: Any, **options: Any) -> str:
        return write_raster(folder / f"{name}.tif", *arguments, **options)

    sound = [
        raster("utm", heights, utm, "EPSG:32633"),
        raster("degrees", heights, degrees, "EPSG:4326", kind="Int16"),
        raster("feet", heights / 0.3048, utm, "EPSG:32633", unit="ft"),
        raster("turned", heights, turned, "EPSG:32633"),
        raster("mercator", heights, mercator, "EPSG:3857"),
        raster("holes", holes, degrees, "EPSG:4326", no_data=-32768, kind="Int16"),
        raster("upward", heights[::-1], upward, "EPSG:32633"),
    ]
    odd = [
        raster("two_bands", np.stack([heights, heights / 2]), utm, "EPSG:32633"),
        raster("no_crs", heights, utm, ""),
        raster("flat", np.full_like(heights, 5.0), utm, "EPSG:32633"),
        raster("void", np.full_like(heights, np.nan), utm, "EPSG:32633", no_data=np.nan),
        raster("infinite", with_one(np.inf), utm, "EPSG:32633"),
        raster("not_a_number", with_one(np.nan), utm, "EPSG:32633"),
        raster("unflagged", with_one(-9999), utm, "EPSG:32633"),
        raster("space", heights * 1e6, utm, "EPSG:32633"),
        raster("enormous", with_one(3e38), utm, "EPSG:32633"),
        raster("one_cell", heights[:1, :1], utm, "EPSG:32633"),
        raster("one_row", heights[:1], utm, "EPSG:32633"),
        raster("two_rows", heights[23:25], (utm[0], utm[1], 0, _UTM[1] + 100, 0, -100.0),
               "EPSG:32633"),
        raster("steep", with_one(8000), utm, "EPSG:32633"),
        raster("complex", heights, utm, "EPSG:32633", kind="CFloat32"),
        raster("bytes", heights / 4, utm, "EPSG:32633", kind="Byte"),
        raster("local", heights, utm, 'LOCAL_CS["hall",UNIT["metre",1]]'),
        raster("centred", heights, utm, "EPSG:4978"),
        raster("pole", heights, _around(0, 0, 4800, 4800), "EPSG:3031"),
        raster("antimeridian", heights, _around(180, -16, 0.05, 0.05), "EPSG:4326"),
        raster("far_north", heights, _around(14.4, 89.99, 0.05, 0.05), "EPSG:4326"),
        raster("beyond_the_pole", heights, _around(14.4, 90.0, 0.05, 0.05), "EPSG:4326"),
        raster("thin_cells", heights, _around(*_UTM, 4800, 48e-6), "EPSG:32633"),
        raster("tiny_cells", heights, _around(*_UTM, 1e-9, 1e-9), "EPSG:32633"),
        raster("wide_cells", heights, _around(*_UTM, 1e12, 1e12), "EPSG:32633"),
        raster("no_cells", heights, (0, 0, 0, 0, 0, 0), "EPSG:32633"),
        raster("endless_cells", heights, (utm[0], np.inf, 0, utm[3], 0, np.nan), "EPSG:32633"),
    ]  # fmt: skip
    return sound, odd


def _layer(path: Path, crs: str, fields: dict[str, list[Any]], shapes: list[str | None]) -> str:
    """Write shapes, given as well-known text, with their fields."""
    from osgeo import ogr, osr

    ogr.UseExceptions()
    reference = osr.SpatialReference()
    if crs:
        reference.SetFromUserInput(crs)
        reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer(path.stem, reference if crs else None, ogr.wkbUnknown)
    for name, values in fields.items():
        text = any(isinstance(value, str) for value in values)
        layer.CreateField(ogr.FieldDefn(name, ogr.OFTString if text else ogr.OFTReal))
    for number, shape in enumerate(shapes):
        feature = ogr.Feature(layer.GetLayerDefn())
        for name, values in fields.items():
            if values[number] is not None:
                feature.SetField(name, values[number])
        if shape is not None:
            feature.SetGeometry(ogr.CreateGeometryFromWkt(shape))
        layer.CreateFeature(feature)
        del feature
    del layer, source
    return str(path)


def _layers(folder: Path) -> dict[str, list[str]]:
    """Return layers of points, lines and polygons, good ones first."""
    x, y = _UTM

    def layer(name: str, *rest: Any) -> str:
        return _layer(folder / f"{name}.gpkg", *rest)

    around = [f"POINT ({x + dx} {y + dy})" for dx, dy in ((-1600, 0), (0, 1500), (1400, -300))]
    named = {"name": ["west", "n/o:rth <b>", "west"], "height": [1.0, None, -5.0]}
    lofty = {"name": [None, "", "x" * 300], "height": [1e9, -1e300, 0.0]}
    strange: list[str | None] = [None, "POINT EMPTY", "POINT (1e300 -1e300)"]
    ring = f"{x} {y}, {x + 300} {y}, {x} {y + 300}, {x} {y}"
    body = {"density": [2.0], "base": [100.0], "top": [600.0]}
    return {
        "points": [
            layer("sites", "EPSG:32633", named, around),
            layer("one_site", "EPSG:4326", {}, ["POINT (14.4055 40.8205)"]),
            layer("several", "EPSG:32633", {}, [f"MULTIPOINT ({x - 1600} {y}, {x} {y + 1500})"]),
            layer("no_sites", "EPSG:32633", {"name": []}, []),
            layer("lofty_sites", "EPSG:32633", lofty, around),
            layer("strange_sites", "EPSG:32633", {}, strange),
            layer("sites_without_crs", "", {}, around),
            layer("sites_elsewhere", "EPSG:4326", {}, ["POINT (0 0)", "POINT (0 89.9999)"]),
        ],
        "lines": [
            layer("road", "EPSG:32633", {}, [f"LINESTRING ({x - 900} {y}, {x + 900} {y + 5})"]),
            layer("dot", "EPSG:32633", {}, [f"LINESTRING ({x} {y}, {x} {y})"]),
            layer("roads", "EPSG:4326", {}, [None, "LINESTRING EMPTY",
                  "MULTILINESTRING ((14.4 40.8, 14.45 40.85), (0 0, 1e9 1e9))"]),
        ],
        "polygons": [
            layer("body", "EPSG:32633", body, [f"POLYGON (({ring}))"]),
            layer("bow", "EPSG:32633", {**body, "top": [-5.0]},
                  [f"POLYGON (({x} {y}, {x + 99} {y + 99}, {x + 99} {y}, {x} {y + 99}, {x} {y}))"]),
            layer("body_without_fields", "EPSG:32633", {}, [f"POLYGON (({ring}))"]),
        ],
    }  # fmt: skip


_TABLES = {
    "table.csv": "azimuth,elevation,counts,error\n"
    + "\n".join(f"{a},{e},{10 * e + a % 7},2" for e in (5, 10, 15) for a in (350, 355, 360, 365)),
    "blanks.txt": "\n".join(f"{a} {z} {a * z // 9}" for z in (60, 70, 80) for a in (10, 20)),
    "matrix.txt": "\n".join(" ".join(str(i * j) for j in range(12)) for i in range(8)),
    "radians.tsv": "azimuth [rad]\tzenith [rad]\tflux\n0.1\t1.2\t3e-3\n0.2\t1.2\tnan\n",
    "semicolons.csv": "azimut;zenith;wert\n1,5;60;3,2\n2,5;60;4,1\n",
}
_JUNK = {
    "empty.txt": b"",
    "words.txt": b"nothing to see here\n",
    "zeros.bin": b"\0" * 300,
    "wide.txt": "azimuth,elevation,counts\n1,2,3\n".encode("utf-16"),
    "latin.csv": "azimut,höhe,wert\n1,2,3\n".encode("latin-1"),
    "one.txt": b"7",
    "long.csv": b"1," * 50_000,
    "huge.csv": b"azimuth,elevation,counts\n1e308,1e-320,1e400\n-1e308,2,3\n",
    "N40E014.hgt": b"\x01\x02" * 777,
    "no.tif": b"II*\0\x08\0\0\0",
    "layer.gpkg": b"SQLite format 3\0" + b"\0" * 100,
}


def _tile(path: Path, cells: int) -> str:
    """Write the tile of one degree around the cone, packed where its name says so."""
    tile = np.zeros((cells, cells), ">i2")
    row, column = round(0.1795 * (cells - 1)), round(0.425 * (cells - 1))
    tile[row - 24 : row + 24, column - 24 : column + 24] = cone()
    tile[row + 40, column] = -32768
    content = tile.tobytes()
    path.write_bytes(gzip.compress(content, 1) if path.suffix == ".gz" else content)
    return str(path)


def make_scene(folder: Path, client: Client) -> Scene:
    """Write everything; muograms come from the algorithms themselves."""
    folder.mkdir()
    scene = Scene(folder)
    scene.dems, scene.odd_dems = _terrain(folder)
    scene.layers = _layers(folder)
    for name, text in _TABLES.items():
        (folder / name).write_text(text, encoding="utf-8")
        scene.tables.append(str(folder / name))
    for name, content in _JUNK.items():
        (folder / name).write_bytes(content)
        scene.odd_files.append(str(folder / name))
    (folder / "tile").mkdir()
    scene.tile = _tile(folder / "tile" / "N40E014.hgt", 1201)
    scene.packed_tile = _tile(folder / "N40E014.hgt.gz", 3601)
    scene.sound = {
        "TARGET": MIDDLE,
        "SOURCE": f"file://{folder}/{{tile}}.hgt.gz",
        "MAX_DISTANCE": 1600.0,
        "SPACING": 400.0,
        "WORKERS": 1,
    }
    view = {"DEM": scene.dems[0], "TARGET": MIDDLE, "ELEVATION_APERTURE": 16,
            "AZIMUTH_PIXELS": 12, "ELEVATION_PIXELS": 9}  # fmt: skip
    quantities = ("THICKNESS", "OPACITY", "FLUX", "OPEN_SKY", "TRANSMISSION", "EXPOSURE",
                  "DISTANCE", "MINIMUM_ENERGY")  # fmt: skip
    jobs = [
        ("radiography", FOOT, quantities, {}),
        ("radiography", "14.425,40.836 [EPSG:4326]", quantities, {}),
        ("expectedcounts", FOOT, ("COUNTS", "OPEN_SKY_COUNTS", "ACCEPTANCE", "THICKNESS"),
         {"PRESET": "custom", "BARS_X": 4, "PIXEL_SIZE": 5, "SEPARATION": 90, "DAYS": 3}),
    ]  # fmt: skip
    for number, (algorithm, detector, wanted, more) in enumerate(jobs):
        outputs = {name: str(folder / f"{name.lower()}_{number}.tif") for name in wanted}
        plan = {key: value for key, value in view.items() if algorithm == "radiography" or
                key in ("DEM", "TARGET")}  # fmt: skip
        told = client.run(algorithm, {**plan, "DETECTOR": detector, **more, **outputs})
        if told["end"] != "done":
            raise RuntimeError(told["sentence"])
        for name, path in outputs.items():
            scene.muograms.setdefault(name.lower(), []).append(path)
    for quantity in ("counts", "open_sky_counts"):
        _round(scene.muograms[quantity][0])
    for quantity in _MEASURED:
        for path in scene.muograms[quantity][:2]:
            error = Path(path).with_name(Path(path).name.replace(quantity, f"{quantity}_error"))
            _write_error(Path(path), error)
            scene.muograms.setdefault(f"{quantity}_error", []).append(str(error))
    return scene


def _round(path: str) -> None:
    """Make whole numbers of expected counts, as if they were counted."""
    from osgeo import gdal

    gdal.UseExceptions()
    dataset = gdal.Open(path, gdal.GA_Update)
    band = dataset.GetRasterBand(1)
    band.WriteArray(np.round(band.ReadAsArray()))
    del band, dataset


def _write_error(source: Path, target: Path) -> None:
    """Write a muogram's errors, a tenth of its values."""
    muogram = read_muogram(source)
    quantity = f"{muogram.quantity}_error"
    write_muogram(replace(muogram, quantity=quantity, values=0.1 * muogram.values), target)

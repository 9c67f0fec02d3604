"""Shared fixtures: library, terrain, a running QGIS, and a server that misbehaves."""

import contextlib
import http.server
import importlib.util
import os
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

#: The package name is the folder's name, whatever that is; the tests give it one.
ALIAS = "muysc_under_test"


@pytest.fixture(scope="session")
def data_folder():
    return ROOT / "tests" / "data"


@pytest.fixture(scope="session")
def qgis_application(tmp_path_factory):
    profile = tmp_path_factory.mktemp("profile")
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = str(profile)
    from qgis.core import QgsApplication

    # With windows, which are drawn nowhere: there can be only one application, and the
    # tests of the desktop need it.
    application = QgsApplication([], True, str(profile))
    application.initQgis()
    sys.path.append(str(Path(application.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    # Not torn down by exitQgis(): Python still refers to what that would delete.
    return application


@pytest.fixture(scope="session")
def provider(qgis_application):
    spec = importlib.util.spec_from_file_location(
        ALIAS, ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules[ALIAS] = package
    spec.loader.exec_module(package)
    plugin = package.classFactory(None)
    plugin.initProcessing()
    yield plugin.provider
    plugin.unload()


class TileServer:
    """A server of files on this machine that also misbehaves as it is told.

    `files` are the bytes by path, `behaviours` functions by path that get the request's
    handler; every other path is not found. `requests` are the paths asked for.
    """

    def __init__(self):
        self.files, self.behaviours, self.requests = {}, {}, []
        #: Set when the server stops, so that stalled answers end.
        self.stopped = threading.Event()
        outer = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def log_message(self, *arguments):
                pass

            def answer(self, status, content=b"", **headers):
                self.send_response(status)
                told = {name.replace("_", "-"): value for name, value in headers.items()}
                for name, value in {"Content-Length": len(content), **told}.items():
                    self.send_header(name, str(value))
                self.end_headers()
                # The client may have had enough.
                with contextlib.suppress(OSError):
                    self.wfile.write(content)

            def do_GET(self):
                outer.requests.append(self.path)
                path = self.path.partition("?")[0]
                if path in outer.behaviours:
                    outer.behaviours[path](self)
                elif path in outer.files:
                    self.answer(200, outer.files[path])
                else:
                    self.answer(404, b"nothing here")

        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        self.url = f"http://127.0.0.1:{self._server.server_port}"
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.01,))
        self._thread.start()

    def stop(self):
        self.stopped.set()
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


@pytest.fixture
def tile_server():
    server = TileServer()
    yield server
    server.stop()


@pytest.fixture(scope="session")
def vesuvius_tile(data_folder):
    """Return tile N40E014 in one arc second: Vesuvius where it is, sea level around it."""
    gdal = pytest.importorskip("osgeo.gdal")
    dataset = gdal.Open(str(data_folder / "vesuvius_srtmgl1.tif"))
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    heights = dataset.ReadAsArray()
    # The first cell's centre, counted from the tile's north-western one.
    column = round((left + step_x / 2 - 14) * 3600)
    row = round((41 - (top + step_y / 2)) * 3600)
    tile = np.zeros((3601, 3601), ">i2")
    tile[row : row + heights.shape[0], column : column + heights.shape[1]] = heights
    tile.flags.writeable = False
    return tile

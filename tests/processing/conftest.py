"""A running QGIS without a window, and the plugin loaded as QGIS loads it."""

import importlib.util
import os
import sys
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

ROOT = Path(__file__).resolve().parent.parent.parent
#: The package name is the folder's name, whatever that is; the tests give it one.
ALIAS = "muysc_under_test"


@pytest.fixture(scope="session")
def qgis_application(tmp_path_factory):
    profile = tmp_path_factory.mktemp("profile")
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = str(profile)
    from qgis.core import QgsApplication

    application = QgsApplication([], False, str(profile))
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


@pytest.fixture
def recorder(qgis_application):
    """Make feedbacks that keep what is said, and cancel at a percentage."""
    from qgis.core import QgsProcessingFeedback

    class Recorder(QgsProcessingFeedback):
        def __init__(self, cancel_at=None):
            super().__init__(False)
            self.warnings, self.infos, self.percents = [], [], []
            self.cancel_at = cancel_at
            self.progressChanged.connect(self.note)

        def note(self, percent):
            self.percents.append(percent)
            if self.cancel_at is not None and percent >= self.cancel_at:
                self.cancel()

        def pushWarning(self, text):  # noqa: N802
            self.warnings.append(text)

        def pushInfo(self, text):  # noqa: N802
            self.infos.append(text)

        def reportError(self, text, fatalError=False):  # noqa: N802, N803
            pass

    return Recorder


@pytest.fixture
def feedback(recorder):
    return recorder()


@pytest.fixture
def run(provider, recorder):
    """Run an algorithm of the provider as a script would."""
    import processing

    def run_algorithm(name, parameters, feedback=None):
        return processing.run(f"muysc:{name}", parameters, feedback=feedback or recorder())

    return run_algorithm


@pytest.fixture
def vesuvius(data_folder):
    """The main job on the real DEM, coarse enough for many tests."""
    return {
        "DEM": str(data_folder / "vesuvius_srtmgl1.tif"),
        "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
        "TARGET": "14.424745,40.823729 [EPSG:4326]",
        "AZIMUTH_APERTURE": 42,
        "ELEVATION_APERTURE": 22,
        "AZIMUTH_PIXELS": 21,
        "ELEVATION_PIXELS": 11,
    }

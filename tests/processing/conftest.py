"""Running algorithms as a script would, and what they say."""

import gzip

import pytest


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


@pytest.fixture(scope="session")
def vesuvius_gzipped(vesuvius_tile):
    return gzip.compress(vesuvius_tile.tobytes(), 1)


@pytest.fixture
def download(run, tile_server, tmp_path, feedback):
    """Download from a folder of the server; returns the results."""

    def download_from(folder="tiles", ending=".hgt.gz", **changes):
        return run(
            "downloadsrtm",
            {
                "EXTENT": "14.4,14.45,40.8,40.85 [EPSG:4326]",
                "SOURCE": f"{tile_server.url}/{folder}/{{latitude}}/{{tile}}{ending}",
                "CACHE": str(tmp_path / "cache"),
                "TIMEOUT": 20,
                "RETRIES": 0,
                "DEM": str(tmp_path / "dem.tif"),
                **changes,
            },
            feedback,
        )

    return download_from


@pytest.fixture
def refused_download(download, tmp_path):
    """Return the sentence with which a download fails, having left nothing behind."""
    from qgis.core import QgsProcessingException

    def sentence(*arguments, **changes):
        with pytest.raises(QgsProcessingException) as failure:
            download(*arguments, **changes)
        assert not [path for path in tmp_path.iterdir() if path.name != "cache"]
        assert not list((tmp_path / "cache").rglob("*.*"))
        text = str(failure.value)
        assert "Traceback" not in text
        return text

    return sentence

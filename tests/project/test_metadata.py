"""What QGIS and its plugin site read about the plugin."""

import configparser
import re

import pytest

import muysc_qgis

#: Without these the plugin site refuses an upload.
REQUIRED = (
    "name", "description", "about", "version", "qgisMinimumVersion", "author", "email",
    "homepage", "tracker", "repository",
)  # fmt: skip


@pytest.fixture
def metadata(root):
    # As QGIS reads it, interpolation included: a bare percent sign would fail here.
    parser = configparser.ConfigParser()
    parser.optionxform = str
    parser.read_string((root / "metadata.txt").read_text(encoding="utf-8"))
    return dict(parser.items("general"))


def test_required_entries_are_filled_in(metadata):
    for key in REQUIRED:
        assert metadata.get(key, "").strip(), key


def test_qgis_3_22_to_4_with_a_processing_provider(metadata):
    assert metadata["qgisMinimumVersion"] == "3.22"
    assert metadata["qgisMaximumVersion"] == "4.99"
    assert metadata["hasProcessingProvider"] == "yes"


def test_the_plugin_site_can_read_it(metadata):
    assert re.fullmatch(r"[^@\s]+@[^@\s]+\.[a-z]+", metadata["email"])
    for key in ("homepage", "tracker", "repository"):
        assert re.fullmatch(r"https://\S+", metadata[key])
    # Names, descriptions and tags are searched and must be English.
    for key in ("name", "description", "about", "tags"):
        assert metadata[key].isascii()


def test_the_icon_is_there(metadata, root):
    assert (root / metadata["icon"]).read_text(encoding="utf-8").startswith("<?xml")


def test_the_version_is_the_same_everywhere(metadata, root):
    changes = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = re.search(r"^## \[(\d[^]]*)\]", changes, re.MULTILINE).group(1)
    assert metadata["version"] == muysc_qgis.__version__ == newest


def test_the_licence_is_gpl_2_in_full(metadata, root):
    licence = (root / "LICENSE").read_text(encoding="utf-8")
    assert metadata["license"] == "GPL-2.0-or-later"
    assert "GNU GENERAL PUBLIC LICENSE" in licence
    assert "Version 2, June 1991" in licence
    assert "END OF TERMS AND CONDITIONS" in licence

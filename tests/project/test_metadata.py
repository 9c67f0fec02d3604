"""What QGIS and its plugin site read about the plugin."""

import configparser
import re

import pytest

import muysc_qgis
from tools import package


@pytest.fixture
def metadata(root):
    # As QGIS reads it, interpolation included: a bare percent sign would fail here.
    parser = configparser.ConfigParser()
    parser.optionxform = str
    parser.read_string((root / "metadata.txt").read_text(encoding="utf-8"))
    return dict(parser.items("general"))


def test_the_plugin_site_accepts_it(root):
    text = (root / "metadata.txt").read_text(encoding="utf-8")
    assert package.faults_of_metadata(text) == []


def test_qgis_3_22_to_4_with_a_processing_provider(metadata):
    assert metadata["qgisMinimumVersion"] == "3.22"
    assert metadata["qgisMaximumVersion"] == "4.99"
    assert metadata["hasProcessingProvider"] == "yes"


def test_the_icon_is_there(metadata, root):
    assert (root / metadata["icon"]).read_text(encoding="utf-8").startswith("<?xml")


def test_the_version_stands_in_metadata_and_the_documents_follow(metadata, root):
    version = metadata["version"]
    assert muysc_qgis.__version__ == version
    assert metadata["changelog"].startswith(f"{version}: ")
    changes = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.search(r"^## \[(\d[^]]*)\]", changes, re.MULTILINE)[1] == version
    citation = (root / "CITATION.cff").read_text(encoding="utf-8")
    assert re.search(r"^version: (.+)$", citation, re.MULTILINE)[1] == version


def test_the_citation_names_the_tool_and_the_method(metadata, root):
    yaml = pytest.importorskip("yaml")
    citation = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["cff-version"] == "1.2.0"
    assert citation["title"] == metadata["name"]
    assert citation["license"] == metadata["license"]
    assert citation["authors"] == [{"name": metadata["author"]}]
    for key in ("message", "type", "abstract"):
        assert citation[key].strip()
    (paper,) = citation["references"]
    assert paper["type"] == "article"
    assert paper["identifiers"] == [{"type": "other", "value": "arXiv:2303.02627"}]


def test_the_licence_is_gpl_2_in_full(metadata, root):
    licence = (root / "LICENSE").read_text(encoding="utf-8")
    assert metadata["license"] == "GPL-2.0-or-later"
    assert "GNU GENERAL PUBLIC LICENSE" in licence
    assert "Version 2, June 1991" in licence
    assert "END OF TERMS AND CONDITIONS" in licence

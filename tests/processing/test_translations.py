"""Spanish beside English: nothing is left out, and what must stay the same does."""

import importlib
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
SPANISH = ROOT / "i18n" / "muysc_es.ts"

#: What a translation must not change: placeholders, tags, numbers, units, words of scripts.
_KEPT = {
    "placeholders": r"\{\w*\}|%\d",
    "tags": r"</?\w+>",
    "numbers": r"\d+(?:\.\d+)?",
    "units": r"GeV/c|GeV|TeV|g/cm[²³]|cm⁻² sr⁻¹ day⁻¹|cm² sr|mrad|GiB|°|%",
    "words": r"\b[A-Z]+_[A-Z_]+\b|\[EPSG:\w+\]|muysc[:/]\w+|https?://\S+",
}

_TITLES = """
import importlib.util, json, os, sys
from qgis.core import QgsApplication, QgsSettings
root, profile, language = sys.argv[1:]
application = QgsApplication([], False, profile)
application.initQgis()
QgsSettings().setValue("locale/userLocale", language)
QgsSettings().setValue("locale/overrideFlag", True)
spec = importlib.util.spec_from_file_location(
    "any_name", root + "/__init__.py", submodule_search_locations=[root]
)
package = sys.modules["any_name"] = importlib.util.module_from_spec(spec)
spec.loader.exec_module(package)
plugin = package.classFactory(None)
plugin.initProcessing()
shown = {}
for algorithm in plugin.provider.algorithms():
    parameters = algorithm.parameterDefinitions()
    shown[algorithm.name()] = [
        algorithm.displayName(), algorithm.group(), algorithm.shortHelpString(),
        [one.description() for one in parameters], [one.help() for one in parameters],
        [one.description() for one in algorithm.outputDefinitions()],
    ]
plugin.unload()
print(json.dumps([shown, plugin.translator]))
"""


@pytest.fixture(scope="module")
def shown(tmp_path_factory):
    """Return what the toolbox shows in a language, in a process of its own."""
    import json

    def show(language):
        profile = tmp_path_factory.mktemp(language)
        done = subprocess.run(
            ["/usr/bin/python3", "-c", _TITLES, str(ROOT), str(profile), language],
            env={
                **os.environ,
                "HOME": str(profile),
                "QGIS_CUSTOM_CONFIG_PATH": str(profile),
                "QT_QPA_PLATFORM": "offscreen",
            },
            capture_output=True,
            text=True,
            check=False,
        )
        lines = done.stdout.splitlines()
        assert lines, done.stderr
        titles, translator = json.loads(lines[-1])
        assert translator is None
        return titles

    return show


@pytest.fixture(scope="module")
def messages():
    return [
        (one.findtext("source"), one.find("translation"))
        for one in ElementTree.parse(SPANISH).iter("message")  # noqa: S314 - our own file
    ]


@pytest.fixture(scope="module")
def current(provider):
    """Return every text of toolbox and dock."""
    translations = importlib.import_module("tools.translations")
    package = sys.modules[type(provider).__module__.split(".")[0]]
    # The script loads the plugin under a name of its own; here it is loaded already.
    translations.ALIAS = package.__name__
    return {
        *translations.texts_of_provider(provider),
        *translations.texts_of_sources(ROOT / "muysc_qgis" / "gui"),
        *translations.texts_of_tables(),
    } - {""}


def test_every_text_has_a_finished_spanish_translation(current, messages):
    finished = {
        source for source, said in messages if said.text and said.get("type") != "unfinished"
    }
    assert current - finished == set(), "run make translations, and translate what it says"


def test_translations_keep_placeholders_numbers_and_units(current, messages):
    for source, said in messages:
        if source not in current:
            continue
        for kind, pattern in _KEPT.items():
            expected = Counter(re.findall(pattern, source))
            assert Counter(re.findall(pattern, said.text)) == expected, f"{kind} of “{source}”"


def test_the_compiled_translation_is_that_of_the_source(qgis_application, messages):
    from qgis.PyQt.QtCore import QTranslator

    translator = QTranslator()
    assert translator.load(str(SPANISH.with_suffix(".qm")))
    for source, said in messages:
        if said.get("type") is None:
            found = translator.translate("MUYSC", source.encode())
            # What is the same in both languages is left out.
            assert found == said.text or (not found and source == said.text), source


def test_spanish_and_english_by_the_setting_of_qgis(shown, messages):
    spanish, english = shown("es_CO"), shown("en")
    assert spanish["radiography"][0] == "Radiografía de muones"
    assert spanish["volcanosurvey"][0] == "Campaña en un volcán"
    assert english["radiography"][0] == "Muon radiography"
    said = {source: one.text for source, one in messages}
    for name, (title, group, _, labels, helps, outputs) in english.items():
        assert spanish[name][0] == said[title]
        assert spanish[name][1] == said[group]
        assert spanish[name][3] == [said[label] for label in labels]
        assert spanish[name][4] == [said[one] if one else one for one in helps]
        assert spanish[name][5] == [said[one] for one in outputs]


def test_a_language_without_translation_shows_english(shown):
    assert shown("fi")["radiography"][0] == "Muon radiography"


def test_refusals_and_labels_of_reports_stay_english(provider):
    package = type(provider).__module__.split(".")[0]
    language = importlib.import_module(f"{package}.processing_algorithms.language")
    from qgis.core import QgsProcessingParameterNumber

    parameter = QgsProcessingParameterNumber("DAYS", "Days of counting")
    parameter.setHelp("Give the days.")
    language.translated(parameter)
    parameter.setDescription("Días de conteo")
    parameter.setHelp("Indique los días.")
    assert language.english_label(parameter) == "Days of counting"
    assert language.english_help(parameter) == "Give the days."

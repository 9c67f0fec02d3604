"""Bring the files of translations up to date: what the algorithms and the desktop say.

Needs QGIS and Qt's ``lrelease``; run as ``make translations`` after any change of a text.
Texts come from the algorithms themselves, because many are put together when they are
declared, and from ``tr("…")`` in the sources. Translations are kept; those of texts that
are gone are marked as vanished.
"""

from __future__ import annotations

import ast
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from xml.etree import ElementTree

from qgis.core import QgsProcessingProvider

from .declared import ALIAS, ROOT, declared_by, load_provider, start_qgis

FOLDER = ROOT / "i18n"
CONTEXT = "MUYSC"
#: Modules and tables of what the dock shows by its title.
TABLES = (
    ("quantities", "QUANTITIES"),
    ("radiography.materials", "MATERIALS"),
    ("radiography.spectra", "MODELS"),
    ("telescope.presets", "PRESETS"),
)
#: Programs of Qt 5 and Qt 6 that compile translations.
COMPILERS = ("lrelease", "/usr/lib/qt6/bin/lrelease", "lrelease-qt6", "lrelease-qt5")


def texts_of_provider(provider: QgsProcessingProvider) -> Iterator[str]:
    """Yield the texts of the toolbox, as they were declared."""
    language = sys.modules[f"{ALIAS}.processing_algorithms.language"]
    base = sys.modules[f"{ALIAS}.processing_algorithms.base"]
    models = sys.modules[f"{ALIAS}.processing_algorithms.models"]
    for algorithm in provider.algorithms():
        if isinstance(algorithm, models.MuyscModel):
            yield from algorithm.texts()
            continue
        yield from (algorithm.TITLE, algorithm.GROUP)
        yield from base.help_paragraphs(algorithm.name())
        for parameter in algorithm.parameterDefinitions():
            yield language.english_label(parameter)
            yield language.english_help(parameter)
        for output in declared_by(algorithm).numbers:
            yield output.description()


def texts_of_sources(folder: Path) -> Iterator[str]:
    """Yield what stands in ``tr("…")`` below a folder."""
    for path in sorted(folder.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "tr":
                text = node.args[0]
                if isinstance(text, ast.Constant):
                    yield str(text.value)


def texts_of_tables() -> Iterator[str]:
    """Yield the names of what the dock lets one choose."""
    library = f"{ALIAS}.muysc_qgis"
    for module, table in TABLES:
        entries = getattr(import_module(f"{library}.{module}"), table)
        yield from (entry.title for entry in entries.values())


def texts() -> list[str]:
    """Return every text once, in the order of the toolbox; needs QGIS in English."""
    known = [
        *texts_of_provider(load_provider()),
        *texts_of_sources(ROOT / "muysc_qgis" / "gui"),
        *texts_of_tables(),
    ]
    return [text for text in dict.fromkeys(known) if text]


def read(path: Path) -> dict[str, str]:
    """Return the finished translations of a file by their text."""
    return {
        message.findtext("source", ""): message.findtext("translation", "")
        for message in ElementTree.parse(path).iter("message")  # noqa: S314 - our own file
        if message.find("translation").get("type") != "unfinished"
    }


def write(path: Path, language: str, current: list[str], translations: dict[str, str]) -> None:
    """Write a file of translations: what is current, then what has vanished."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    gone = [text for text in translations if text not in set(current)]
    for text in [*current, *gone]:
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        translation.text = translations.get(text, "")
        if text in gone:
            translation.set("type", "vanished")
        elif not translation.text:
            translation.set("type", "unfinished")
    ElementTree.indent(root)
    body = ElementTree.tostring(root, encoding="unicode")
    head = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
    path.write_text(f"{head}{body}\n", encoding="utf-8")


def compile_all() -> None:
    """Compile every file of translations."""
    compiler = next(filter(None, map(shutil.which, COMPILERS)), None)
    if compiler is None:
        sys.exit("lrelease is missing; install qttools5-dev-tools (or qt6-l10n-tools on Debian).")
    for path in sorted(FOLDER.glob("*.ts")):
        subprocess.run(  # noqa: S603
            [compiler, "-silent", "-removeidentical", path, "-qm", path.with_suffix(".qm")],
            check=True,
        )


def main() -> None:
    """Update and compile, and say what is not translated yet."""
    with tempfile.TemporaryDirectory() as profile:
        application = start_qgis(profile)
        current = texts()
        for path in sorted(FOLDER.glob("*.ts")):
            language = path.stem.rpartition("_")[2]
            translations = {text: said for text, said in read(path).items() if said}
            write(path, language, current, translations)
            missing = sum(text not in translations for text in current)
            print(f"{path.name}: {len(current)} texts, {missing} of them not translated.")
        compile_all()
        del application


if __name__ == "__main__":
    main()

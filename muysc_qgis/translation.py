"""Texts in the language of QGIS, through Qt's translators."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QLocale, QTranslator

#: Compiled translations, ``muysc_<language>.qm``.
FOLDER = Path(__file__).resolve().parent.parent / "i18n"

#: Context of every text in the files of translations.
CONTEXT = "MUYSC"


def tr(text: str) -> str:
    """Return a text in the language of QGIS, as it is where nobody has translated it."""
    # Qt would look up the note on a file's language for an empty text.
    return str(QCoreApplication.translate(CONTEXT, text)) if text else ""


def language() -> str:
    """Return the language of QGIS in two letters: the user's choice, or that of the system."""
    return str(QgsApplication.instance().locale())[:2]


def install_translator(folder: Path = FOLDER) -> QTranslator | None:
    """Install the translation into the user's language.

    Returns
    -------
    QTranslator or None
        To be kept as long as it serves; None where there is no such translation.
    """
    # Heeds what the user has chosen in QGIS's options, then the system.
    locale = QLocale(QgsApplication.instance().locale())
    translator = QTranslator()
    if not translator.load(locale, "muysc", "_", str(folder)):
        return None
    QCoreApplication.installTranslator(translator)
    return translator

"""Write the pages that Help in a dialog opens: one for each algorithm, in every language.

Needs QGIS; run as ``make reference``.
"""

from __future__ import annotations

import html
import sys
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterDefinition
from qgis.PyQt.QtCore import QCoreApplication, QTranslator

from .declared import (
    ALIAS,
    ROOT,
    declared_by,
    default,
    in_order,
    is_advanced,
    load_provider,
    options,
    start_qgis,
)

PAGES = ROOT / "docs" / "reference"
#: Words of the pages themselves.
WORDS = {
    "en": ("Parameters", "Parameter", "Meaning", "Default", "Outputs", "Output", "optional",
           "advanced", "One of", "From the command line", "All algorithms"),
    "es": ("Parámetros", "Parámetro", "Significado", "Predeterminado", "Salidas", "Salida",
           "opcional", "avanzado", "Uno de", "Desde la línea de comandos", "Todos los algoritmos"),
}  # fmt: skip

STYLE = """
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.2rem; margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .4rem .6rem;
  border-bottom: 1px solid #8886; }
code, pre { font-family: ui-monospace, monospace; font-size: .9em; }
td:first-child code { white-space: nowrap; }
pre { padding: .8rem; border: 1px solid #8886; border-radius: .3rem; white-space: pre-wrap; }
small { opacity: .75; }
"""


def table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return a table in HTML, of cells that are HTML already."""
    head = "".join(f"<th>{one}</th>" for one in heads)
    body = "\n".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows)
    return f"<table>\n<tr>{head}</tr>\n{body}\n</table>"


def _meaning(one: QgsProcessingParameterDefinition, one_of: str) -> str:
    said = f"<b>{html.escape(one.description())}.</b> {html.escape(one.help())}"
    words = ", ".join(f"<code>{html.escape(word)}</code>" for word in options(one))
    return f"{said} {one_of} {words}." if words else said


def page(algorithm: QgsProcessingAlgorithm, language: str) -> str:
    """Return the page of an algorithm in the language that it speaks."""
    (parameters, parameter, meaning, standard, outputs, output, optional, advanced, one_of,
     command, every) = WORDS[language]  # fmt: skip
    declared = declared_by(algorithm)
    mark = f"<br><small>{advanced}</small>"
    inputs = [
        (
            f"<code>{one.name()}</code>{mark if is_advanced(one) else ''}",
            _meaning(one, one_of),
            html.escape(default(one, optional)),
        )
        for one in declared.inputs
    ]
    files = [(f"<code>{one.name()}</code>", _meaning(one, one_of)) for one in declared.files]
    numbers = [
        (f"<code>{one.name()}</code>", f"<b>{html.escape(one.description())}</b>")
        for one in declared.numbers
    ]
    needed = [f"--{one.name()}=…" for one in declared.inputs if not default(one, optional)]
    line = " ".join(["qgis_process run", algorithm.id(), *needed])
    title = html.escape(algorithm.displayName())
    return f"""<!DOCTYPE html>
<html lang="{language}">
<head><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style></head>
<body>
<p><a href="index.html">{every}</a></p>
<h1>{title}</h1>
<p><code>{algorithm.id()}</code> · {html.escape(algorithm.group())}</p>
{algorithm.shortHelpString() if algorithm.groupId() != "models" else _description(algorithm)}
<h2>{parameters}</h2>
{table((parameter, meaning, standard), inputs)}
<h2>{outputs}</h2>
{table((output, meaning), files + numbers)}
<h2>{command}</h2>
<pre>{html.escape(line)}</pre>
</body>
</html>
"""


def _description(model: QgsProcessingAlgorithm) -> str:
    # The help of a model repeats its parameters.
    return str(model.helpContent()["ALG_DESC"])


def index(algorithms: Iterable[QgsProcessingAlgorithm], language: str) -> str:
    """Return the page that leads to all others."""
    rows = [
        (
            f'<a href="{one.name()}.html">{html.escape(one.displayName())}</a>',
            html.escape(one.group()),
            f"<code>{one.id()}</code>",
        )
        for one in algorithms
    ]
    return f"""<!DOCTYPE html>
<html lang="{language}">
<head><meta charset="utf-8"><title>MUYSC</title><style>{STYLE}</style></head>
<body>
<h1>MUYSC</h1>
{table(("", "", ""), rows)}
</body>
</html>
"""


def all_pages() -> Iterator[tuple[Path, str]]:
    """Yield every page with its file; needs QGIS in English."""
    provider = load_provider()
    translation = sys.modules[f"{ALIAS}.muysc_qgis.translation"]
    for language in WORDS:
        folder = PAGES
        if language != "en":
            translator = QTranslator()
            translator.load(f"muysc_{language}", str(translation.FOLDER))
            QCoreApplication.installTranslator(translator)
            provider.refreshAlgorithms()
            provider.attach_models()
            folder = PAGES / language
        algorithms = in_order(provider)
        yield folder / "index.html", index(algorithms, language)
        for one in algorithms:
            yield folder / f"{one.name()}.html", page(one, language)


def main() -> None:
    """Write every page, and take away those of algorithms that are gone."""
    for path in PAGES.rglob("*.html"):
        path.unlink()
    with tempfile.TemporaryDirectory() as profile:
        application = start_qgis(profile)
        for path, text in all_pages():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        del application
    print(f"Wrote {len([*PAGES.rglob('*.html')])} pages in {PAGES.relative_to(ROOT)}.")


if __name__ == "__main__":
    main()

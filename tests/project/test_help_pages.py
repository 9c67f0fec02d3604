"""Help in a dialog opens a page that is there, in every language, and says what QGIS does."""

import html

import pytest


@pytest.mark.parametrize("folder", ["docs/reference", "docs/reference/es"])
def test_every_algorithm_has_a_page_with_all_its_names(folder, root, declared_by):
    pages = {path.stem: path for path in (root / folder).glob("*.html")}
    algorithms = declared_by(root)
    assert {"index", *(name.split(":")[1] for name in algorithms)} == set(pages), "make reference"
    for algorithm, names in algorithms.items():
        text = pages[algorithm.split(":")[1]].read_text(encoding="utf-8")
        for name in (*names["parameters"], *names["outputs"]):
            assert f"<code>{html.escape(name)}</code>" in text, f"{name} of {algorithm}"

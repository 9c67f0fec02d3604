"""The documents cover the whole interface, and point at files that exist."""

import re

import pytest


@pytest.fixture(scope="module")
def readme(root):
    return (root / "README.md").read_text(encoding="utf-8")


def test_every_algorithm_parameter_and_output_is_documented(readme, declared_by, root):
    texts = [readme, *(path.read_text(encoding="utf-8") for path in root.glob("docs/*.md"))]
    algorithms = declared_by(root)
    assert algorithms
    for algorithm, names in algorithms.items():
        assert f"`{algorithm}`" in readme
        for name in (*names["parameters"], *names["outputs"]):
            assert any(f"`{name}`" in text for text in texts), f"{name} of {algorithm}"


def test_no_algorithm_is_promised_that_does_not_exist(readme, declared_by, root):
    assert set(re.findall(r"muysc:[a-z]+", readme)) == set(declared_by(root))


@pytest.mark.parametrize("document", ["README.md", "CONTRIBUTING.md"])
def test_links_into_the_project_lead_somewhere(document, root):
    text = (root / document).read_text(encoding="utf-8")
    targets = re.findall(r"\]\((?!https?:|#)([^)#]+)", text)
    assert targets
    for target in targets:
        assert (root / target).exists(), target


def test_make_targets_in_the_readme_exist(readme, root):
    makefile = (root / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"`make ([a-z]+)", readme)):
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target

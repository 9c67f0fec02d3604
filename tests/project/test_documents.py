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


def anchors(text):
    """Return the names that headings get as targets of links."""
    headings = re.findall(r"^#+ (.+)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


DOCUMENTS = ("README.md", "CONTRIBUTING.md", "docs/*.md")


def test_links_into_the_project_lead_somewhere(root):
    documents = [path for pattern in DOCUMENTS for path in root.glob(pattern)]
    assert len(documents) > 8
    found = 0
    for document in documents:
        text = document.read_text(encoding="utf-8")
        for name, anchor in re.findall(r"\]\((?!https?:)([^)#]*)#?([^)]*)\)", text):
            target = document.parent / name if name else document
            assert target.exists(), f"{name} in {document.name}"
            if anchor:
                assert anchor in anchors(target.read_text(encoding="utf-8")), (
                    document.name,
                    anchor,
                )
            found += 1
    assert found > 50


def test_every_document_is_in_the_index_of_the_folder(root):
    index = (root / "docs" / "README.md").read_text(encoding="utf-8")
    left_out = {"README.md", "development.md"}  # the latter is no part of a release
    for document in root.glob("docs/*.md"):
        assert document.name in left_out or f"]({document.name})" in index, document.name


def test_the_architecture_names_every_room(root, tracked):
    text = (root / "docs" / "architecture.md").read_text(encoding="utf-8")
    rooms = {path.parts[1] for path in tracked if path.parts[0] == "muysc_qgis" and path.parts[2:]}
    assert len(rooms) > 8
    for room in rooms:
        assert f"| `muysc_qgis/{room}/` |" in text, room
    for path in tracked:
        # Modules beside the rooms, and the folders of everything else.
        if path.parts[0] == "muysc_qgis" and not path.parts[2:] and path.stem != "__init__":
            assert f"`{path.name}`" in text, path.name
        if path.parts[0] in {"tests", "processing_algorithms", "tools", "benchmarks"}:
            assert f"`{path.parts[0]}/`" in text, path.parts[0]


def test_make_targets_in_the_readme_exist(readme, root):
    makefile = (root / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"`make ([a-z]+)", readme)):
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target

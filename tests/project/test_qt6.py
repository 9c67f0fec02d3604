"""The code holds for Qt 6 and QGIS 4, though the tests run on Qt 5.

The names are those by which PyQt 6.11 differs from PyQt 5.15.
"""

import ast
import contextlib
import importlib
import operator
from enum import Enum
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
#: Where names that differ are chosen by version.
COMPAT = {
    ROOT / "processing_algorithms" / "compat.py",
    ROOT / "muysc_qgis" / "gui" / "compat.py",
}
FILES = sorted(
    file
    for folder in ("muysc_qgis", "processing_algorithms", "tools", "tests")
    for file in (ROOT / folder).rglob("*.py")
    if file not in COMPAT
)

#: Packages that tie the code to one Qt, which qgis.PyQt does not.
BOUND = {"PyQt5", "PyQt6", "PySide2", "PySide6", "sip"}
#: What cannot be imported from qgis.PyQt any more, and what stands in its place.
MOVED = {
    "QAction": "in QtGui; take it from gui/compat.py",
    "QActionGroup": "in QtGui; take it through gui/compat.py",
    "QShortcut": "in QtGui; take it through gui/compat.py",
    "QUndoCommand": "in QtGui; take it through gui/compat.py",
    "QUndoStack": "in QtGui; take it through gui/compat.py",
    "QFileSystemModel": "in QtGui; take it through gui/compat.py",
    "QSvgWidget": "in QtSvgWidgets; paint with QSvgRenderer",
    "QGraphicsSvgItem": "in QtSvgWidgets; paint with QSvgRenderer",
    "QDesktopWidget": "QScreen",
    "QRegExp": "QRegularExpression, or Python's re",
    "QRegExpValidator": "QRegularExpressionValidator",
    "QTextCodec": "Python's codecs",
    "QStateMachine": "gone from PyQt",
    "QXmlSimpleReader": "QXmlStreamReader",
    "QNetworkSession": "gone without a need",
    "QVariant": "QMetaType for types, Python's own values for the rest; see compat.py",
    "qApp": "QApplication.instance()",
    "qrand": "Python's random",
}
#: Methods that are gone, and what to call.
REMOVED = {
    "exec_": "exec",
    "print_": "print",
    "toTime_t": "toSecsSinceEpoch",
    "fromTime_t": "fromSecsSinceEpoch",
    "setTime_t": "setSecsSinceEpoch",
    "localPos": "compat.position_of(event)",
    "windowPos": "scenePosition",
    "posF": "position",
    "globalPosF": "globalPosition",
    "setCodec": "setEncoding",
    "setTabStopWidth": "setTabStopDistance",
    "setTabStop": "setTabStopDistance",
    "getTextMargins": "textMargins",
    "filterRegExp": "filterRegularExpression",
    "setFilterRegExp": "setFilterRegularExpression",
    "byteCount": "sizeInBytes",
    "screenGeometry": "screen().geometry",
    "setDefaultCaCertificates": "QSslConfiguration",
    "hasPendingEvents": "gone without a need",
}


def tree_of(file):
    return ast.parse(file.read_text(encoding="utf-8"))


def imports(tree):
    """Yield pairs of module and name, the name empty where a module is imported whole."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, "") for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield from ((node.module, alias.name) for alias in node.names)


def outdated_imports(tree):
    """Return the imports that Qt 6 does not know, with the remedy."""
    told = []
    for module, name in imports(tree):
        if module.split(".")[0] in BOUND:
            told.append(f"{module}: import it from qgis.PyQt")
        elif module.startswith("qgis.PyQt") and name in MOVED:
            told.append(f"{name}: {MOVED[name]}")
    return told


def outdated_calls(tree):
    """Return what is asked of objects that Qt 6 does not know, with the remedy."""
    told = []
    for node in ast.walk(tree):
        if not isinstance(node, ast.Attribute):
            continue
        if node.attr in REMOVED:
            told.append(f"line {node.lineno}: {node.attr} is now {REMOVED[node.attr]}")
        if node.attr in ("connect", "disconnect", "emit") and isinstance(node.value, ast.Subscript):
            told.append(f"line {node.lineno}: signals have no overloads")
        measured = node.value.func if isinstance(node.value, ast.Call) else None
        if node.attr == "width" and getattr(measured, "attr", "") == "fontMetrics":
            told.append(f"line {node.lineno}: width of a text is horizontalAdvance")
    return told


def qgis_names(tree):
    """Return what the names of a file stand for that come from QGIS, by name.

    Short names given to classes and enumerations on the way are followed; what this
    QGIS does not know is left out.
    """
    names = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "qgis":
            module = importlib.import_module(node.module)
            for alias in node.names:
                with contextlib.suppress(AttributeError):
                    names[alias.asname or alias.name] = getattr(module, alias.name)
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            with contextlib.suppress(LookupError, AttributeError, TypeError):
                names[node.targets[0].id] = meaning(node.value, names)
    return names


def meaning(node, names):
    """Return what a dotted name stands for.

    Raises
    ------
    LookupError, AttributeError, TypeError
        If that cannot be told from the names.
    """
    first, *rest = ast.unparse(node).split(".")
    return operator.attrgetter(".".join(rest))(names[first]) if rest else names[first]


def is_enumerated(value):
    """Say whether a value is one of an enumeration's, Python's or that of PyQt 5."""
    return isinstance(value, Enum) or (isinstance(value, int) and type(value) not in (int, bool))


def unscoped_enums(tree):
    """Return the values of enumerations that are not called by their enumeration's name."""
    names = qgis_names(tree)
    told = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            with contextlib.suppress(LookupError, AttributeError, TypeError):
                value = meaning(node, names)
                if is_enumerated(value) and meaning(node.value, names) is not type(value):
                    told.append(f"line {node.lineno}: {ast.unparse(node)} of {type(value)}")
    return told


@pytest.mark.parametrize("find", [outdated_imports, outdated_calls, unscoped_enums])
def test_nothing_stands_in_the_code_that_qt_6_does_not_know(find, qgis_application):
    told = {str(file.relative_to(ROOT)): find(tree_of(file)) for file in FILES}
    assert len(told) > 100
    assert {name: lines for name, lines in told.items() if lines} == {}


@pytest.mark.parametrize(
    ("find", "code", "found"),
    [
        (outdated_imports, "from PyQt5.QtCore import Qt", True),
        (outdated_imports, "from qgis.PyQt.QtWidgets import QAction", True),
        (outdated_imports, "from qgis.PyQt.QtCore import QVariant", True),
        (outdated_imports, "from qgis.PyQt.QtCore import Qt", False),
        (outdated_calls, "dialog.exec_()", True),
        (outdated_calls, "dialog.exec()", False),
        (outdated_calls, "box.activated[str].connect(print)", True),
        (outdated_calls, "boxes[0].activated.connect(print)", False),
        (outdated_calls, "label.fontMetrics().width('text')", True),
        (unscoped_enums, "from qgis.PyQt.QtCore import Qt\nQt.AlignTop", True),
        (unscoped_enums, "from qgis.PyQt.QtCore import Qt\nQt.AlignmentFlag.AlignTop", False),
        (unscoped_enums, "from qgis.core import QgsWkbTypes as w\nw.PointZ", True),
        (unscoped_enums, "from qgis.core import QgsWkbTypes as w\nw.Type.PointZ", False),
        (unscoped_enums, "from qgis import core\nk = core.Qgis\nk.Critical", True),
        (unscoped_enums, "from qgis import core\nk = core.Qgis.MessageLevel\nk.Critical", False),
        (unscoped_enums, "from qgis.core import Qgis\nQgis.QGIS_VERSION_INT", False),
    ],
)
def test_the_checks_see_what_they_look_for(find, code, found, qgis_application):
    assert bool(find(ast.parse(code))) == found

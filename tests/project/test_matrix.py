"""The table of results on every supported QGIS."""

import pytest

from tools import matrix

_REPORT = """<?xml version="1.0" encoding="utf-8"?>
<testsuites><testsuite name="pytest" errors="1" failures="1" skipped="1" tests="4">
<testcase classname="tests.gui.test_dock" name="test_a_click" time="0.1"/>
<testcase classname="tests.gui.test_dock" name="test_a_drag[1]"><failure message="1"/></testcase>
<testcase classname="tests.cli.test_run" name="test_help"><error message="2"/></testcase>
<testcase classname="tests.cli.test_run" name="test_mulder"><skipped message="3"/></testcase>
</testsuite></testsuites>
"""


def test_counts_and_names_come_from_the_report_of_pytest(tmp_path):
    report = tmp_path / "report.xml"
    report.write_text(_REPORT, encoding="utf-8")
    counts, failed = matrix.results_of(report)
    assert counts == {"passed": 1, "failed": 2, "skipped": 1}
    assert failed == ["tests.gui.test_dock::test_a_drag[1]", "tests.cli.test_run::test_help"]


def test_the_table_has_a_row_for_each_system_and_names_what_failed():
    columns = {"QGIS": "3.40.6", "passed": 7, "failed": 1}
    one = matrix.Result("sid", columns, ["tests.gui::test_dock failed."])
    table = matrix.table_of([one]).splitlines()
    assert table[0] == "| System | QGIS | passed | failed |"
    assert table[2] == "| sid | 3.40.6 | 7 | 1 |"
    assert table[-1] == "- sid: tests.gui::test_dock failed."


def test_without_root_one_sentence_says_so(monkeypatch):
    monkeypatch.setattr(matrix.os, "geteuid", lambda: 1000)
    with pytest.raises(matrix.MatrixError, match="root") as refused:
        matrix.main([])
    assert len(str(refused.value).splitlines()) == 1

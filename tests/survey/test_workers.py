"""Work handed out: the same results however it is done, and what happens when it goes wrong."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.survey import local
from muysc_qgis.survey.blocks import BlockFolder, remove_finished
from muysc_qgis.survey.job import answer
from muysc_qgis.survey.local import compute_locally, python_program
from muysc_qgis.survey.run import default_workers, run_job
from muysc_qgis.workflows.site_assessment import survey_job

#: Small blocks, so that a short survey has several.
BLOCK_ITEMS = 4
COUNT = 2 * BLOCK_ITEMS + 3


def alive(process):
    """Return whether a process runs; one that has ended and is not fetched yet does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def children():
    """Return the processes that this one has started and that still run."""
    found = []
    for task in Path(f"/proc/{os.getpid()}/task").iterdir():
        # Threads come and go.
        with contextlib.suppress(FileNotFoundError):
            found += (task / "children").read_text().split()
    return [int(child) for child in found if alive(child)]


@pytest.fixture
def job(plan, places):
    return replace(survey_job(plan(), places(COUNT)), block_items=BLOCK_ITEMS)


@pytest.fixture
def alone(job, tmp_path):
    return run_job(job, tmp_path / "alone.partial", workers=0)


def test_worker_processes_give_the_same_to_the_last_digit(job, alone, tmp_path):
    before = set(children())
    assert run_job(job, tmp_path / "with.partial", workers=2) == alone
    assert set(children()) == before


def test_a_worker_that_dies_is_replaced_by_the_others(plan, places, tmp_path):
    """The survey is long enough for both workers to be there at once."""
    job = replace(survey_job(plan(), places(8 * COUNT)), block_items=BLOCK_ITEMS)
    alone = run_job(job, tmp_path / "alone.partial", workers=0)
    before, killed = set(children()), []

    def kill_one(fraction):
        started = [child for child in children() if child not in before]
        if len(started) == 2 and not killed:
            os.kill(started[0], signal.SIGKILL)
            killed.append(started[0])
        return True

    assert run_job(job, tmp_path / "with.partial", workers=2, progress=kill_one) == alone
    assert killed


def test_when_all_workers_die_finished_blocks_are_kept(job, alone, tmp_path):
    folder = tmp_path / "with.partial"
    before = set(children())

    def kill_all(fraction):
        if fraction > 0:
            for child in set(children()) - before:
                os.kill(child, signal.SIGKILL)
        return True

    with pytest.raises(MuyscError, match="All worker processes have ended"):
        run_job(job, folder, workers=2, progress=kill_all)
    kept = len(list(folder.glob("block_*.json")))
    assert kept >= 1
    said = []
    assert run_job(job, folder, workers=0, say=said.append) == alone
    assert "were finished by an earlier run" in said[0]


@pytest.mark.parametrize("damage", [b"", b"\xff\0", b"[[1.5, 2", b"{}"])
def test_damaged_blocks_are_computed_again(job, alone, tmp_path, damage):
    folder = tmp_path / "kept.partial"
    assert run_job(job, folder, workers=0) == alone
    (folder / "block_000001.json").write_bytes(damage)
    with pytest.raises(MuyscError, match=r"block_000001\.json cannot be read any more; run again"):
        BlockFolder(folder, job).results()
    assert run_job(job, folder, workers=0) == alone
    (folder / "fingerprint.txt").write_bytes(b"\xff")
    assert BlockFolder(folder, job).pending() == [0, 1, 2]


def test_cancelling_leaves_no_process(job, tmp_path):
    before = set(children())
    begun = []

    def stop(fraction):
        if len(set(children()) - before) == 2 and fraction > 0:
            begun.append(time.monotonic())
        return not begun

    with pytest.raises(Cancelled):
        run_job(job, tmp_path / "with.partial", workers=2, progress=stop)
    assert begun
    assert set(children()) == before


def test_without_a_python_beside_qgis_it_runs_in_this_process(job, alone, tmp_path, monkeypatch):
    monkeypatch.setattr(local, "python_program", lambda: None)
    warned = []
    assert run_job(job, tmp_path / "with.partial", workers=2, warn=warned.append) == alone
    assert "no Python is found beside QGIS" in warned[0]
    assert "in one process instead" in warned[0]


def test_workers_that_cannot_begin_say_why(job, alone, tmp_path, monkeypatch):
    monkeypatch.setattr(local, "_MODULE", "muysc_qgis.no_such_module")
    warned = []
    assert run_job(job, tmp_path / "with.partial", workers=2, warn=warned.append) == alone
    assert "No module named muysc_qgis.no_such_module" in warned[0]


def test_an_item_that_cannot_be_computed_is_answered_with_its_sentence():
    def compute(item, progress):
        raise MuyscError(f"Item {item} is impossible.")

    assert answer(compute, [7, 8]) == {"error": "Item 7 is impossible."}
    assert answer(lambda item, progress: item + 1, [7, 8]) == {"results": [8, 9]}


def test_the_python_of_this_process_is_found_when_qgis_is_the_program(monkeypatch, tmp_path):
    assert python_program() == sys.executable
    # As on macOS: QGIS.app/Contents/MacOS/QGIS and …/MacOS/bin/python3.
    program = tmp_path / "bin" / "python3"
    program.parent.mkdir()
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "QGIS"))
    monkeypatch.setattr(sys, "exec_prefix", str(tmp_path / "elsewhere"))
    assert python_program() == str(program)
    program.unlink()
    assert python_program() is None


def test_blocks_of_another_job_are_not_taken(job, plan, places, tmp_path):
    folder = tmp_path / "x.partial"
    BlockFolder(folder, job).keep(0, ["theirs"])
    assert BlockFolder(folder, job).pending() == [1, 2]
    other = replace(survey_job(plan(days=50.0), places(COUNT)), block_items=BLOCK_ITEMS)
    assert other.fingerprint != job.fingerprint
    assert BlockFolder(folder, other).pending() == [0, 1, 2]


@pytest.mark.parametrize("change", ["heights", "candidates"])
def test_the_fingerprint_follows_the_data(job, change):
    array = np.array(job.arrays[change])
    array.flat[-1] += 1e-9 * abs(array.flat[-1])
    changed = replace(job, arrays={**job.arrays, change: array})
    assert changed.fingerprint != job.fingerprint


def test_half_a_block_does_not_count(job, tmp_path):
    folder = tmp_path / "x.partial"
    kept = BlockFolder(folder, job)
    (folder / "block_000001.partial").write_text("[1, 2")
    assert kept.pending() == [0, 1, 2]


def test_a_folder_of_others_is_left_alone(job, tmp_path):
    folder = tmp_path / "x.partial"
    folder.mkdir()
    (folder / "thesis.tex").write_text("important")
    with pytest.raises(MuyscError, match="is in the way"):
        BlockFolder(folder, job)
    assert (folder / "thesis.tex").read_text() == "important"


def test_a_folder_that_cannot_be_made_is_one_sentence(job, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(MuyscError, match="choose another destination"):
        BlockFolder(tmp_path / "file" / "x.partial", job)


def test_remaining_time_is_told(job, tmp_path, monkeypatch):
    from muysc_qgis.survey import run

    monkeypatch.setattr(run, "_TELL_S", 0.0)
    said = []
    job = replace(job, block_items=2)
    run_job(job, tmp_path / "x.partial", workers=0, say=said.append)
    assert said[0].startswith(f"6 of {COUNT} candidates are done, about ")
    assert said[0].endswith(" s left.")


def test_unfinished_work_is_removed_on_request(job, tmp_path):
    folder = tmp_path / "x.partial"
    BlockFolder(folder, job)
    remove_finished(folder)
    assert not folder.exists()


def test_default_workers_are_the_processors_of_this_process():
    assert 1 <= default_workers() <= os.cpu_count()


def test_unknown_numbers_survive_the_block_file(job, tmp_path):
    kept = BlockFolder(tmp_path / "x.partial", job)
    row = [float("nan"), 0.1, -0.0, 1e300]
    for block in kept.pending():
        kept.keep(block, [row] * len(kept.items(block)))
    np.testing.assert_array_equal(kept.results()[-1], row)
    assert json.loads((tmp_path / "x.partial" / "block_000000.json").read_text())[0][1] == 0.1


def test_blocks_come_once_each(job, tmp_path):
    folder = tmp_path / "x.partial"
    kept = BlockFolder(folder, job)
    wanted = {block: kept.items(block) for block in kept.pending()}
    got = [block for block, _ in compute_locally(folder, wanted, 2, lambda: None)]
    assert sorted(got) == list(wanted)
    assert len(wanted) == 3


_SURVEY = """
import sys
from dataclasses import replace
from pathlib import Path
from muysc_qgis.survey.job import Job
from muysc_qgis.survey.run import run_job
job = replace(Job.load(Path(sys.argv[1])), block_items=2)
run_job(job, Path(sys.argv[2]), workers=2)
"""


def test_a_survey_that_is_killed_takes_its_workers_along_and_goes_on(job, alone, tmp_path):
    saved, folder = tmp_path / "job", tmp_path / "x.partial"
    saved.mkdir()
    job.save(saved)
    root = Path(__file__).resolve().parent.parent.parent
    command = [sys.executable, "-c", _SURVEY, str(saved), str(folder)]
    with subprocess.Popen(command, cwd=root) as survey:
        until(lambda: list(folder.glob("block_*.json")))
        workers = [
            int(child)
            for child in Path(f"/proc/{survey.pid}/task/{survey.pid}/children").read_text().split()
        ]
        survey.kill()
    assert len(workers) == 2
    until(lambda: not any(map(alive, workers)))
    said = []
    results = run_job(replace(job, block_items=2), folder, workers=0, say=said.append)
    np.testing.assert_array_equal(results, alone)
    assert "were finished by an earlier run" in said[0]


def until(ready):
    begun = time.monotonic()
    while not ready():
        assert time.monotonic() - begun < 60, "it does not come to pass"
        time.sleep(0.02)

"""A real Dask scheduler and workers on the loopback interface."""

import os
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.survey.cluster import compute_on_cluster
from muysc_qgis.survey.run import run_job
from muysc_qgis.workflows.site_assessment import survey_job

ROOT = Path(__file__).resolve().parent.parent.parent
COUNT = 24

pytest.importorskip("distributed")


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, folder):
        self.folder = folder
        self.file = folder / "scheduler.json"
        self.processes = {}
        self._start("scheduler", "--port", "0")
        self._wait_for(self.file.exists)
        from distributed import Client

        self.client = Client(scheduler_file=str(self.file), set_as_default=False)
        self.address = self.client.scheduler.address

    def _start(self, kind, *options, name=None, plugin=ROOT):
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        environment.pop("PYTHONPATH", None)
        if plugin is not None:
            environment["PYTHONPATH"] = str(plugin)
        with (self.folder / f"{name or kind}.log").open("w") as log:
            self.processes[name or kind] = subprocess.Popen(
                [sys.executable, "-m", f"distributed.cli.dask_{kind}",
                 "--scheduler-file", str(self.file), "--host", "127.0.0.1", "--no-dashboard",
                 *options],
                cwd=self.folder, env=environment, stdout=log, stderr=log,
            )  # fmt: skip

    def employ(self, *names):
        """Have workers of these names that find the plugin, and no others."""
        for name in {*self.processes} - {"scheduler", *names}:
            self.kill(name)
        self._wait_for(lambda: self.workers() == len(self.processes) - 1)
        for name in names:
            if name not in self.processes:
                self.start_worker(name)

    def start_worker(self, name, plugin=ROOT):
        before = self.workers()
        self._start(
            "worker", "--nthreads", "1", "--no-nanny", "--name", name, name=name, plugin=plugin
        )
        self._wait_for(lambda: self.workers() > before)

    def workers(self):
        return len(self.client.scheduler_info()["workers"])

    def kill(self, name):
        process = self.processes.pop(name)
        process.kill()
        process.wait()

    def stop(self):
        self.client.close()
        for name in [*self.processes]:
            self.kill(name)

    @staticmethod
    def _wait_for(ready):
        begun = time.monotonic()
        while not ready():
            assert time.monotonic() - begun < 60, "the cluster does not come up"
            time.sleep(0.05)


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    started = Cluster(tmp_path_factory.mktemp("cluster"))
    yield started
    started.stop()


@pytest.fixture
def job(plan, places):
    return replace(survey_job(plan(), places(COUNT)), block_items=2)


@pytest.fixture
def alone(job, tmp_path):
    return run_job(job, tmp_path / "alone.partial", workers=0)


def test_a_scheduler_without_workers_is_one_sentence(cluster, job, tmp_path):
    cluster.employ()
    with pytest.raises(MuyscError, match="has no workers; start at least one"):
        run_job(job, tmp_path / "x.partial", scheduler=cluster.address)


def test_a_worker_without_the_plugin_is_named(cluster, job, tmp_path):
    cluster.employ()
    cluster.start_worker("bare", plugin=None)
    with pytest.raises(MuyscError, match=r"worker tcp://.* cannot find the plugin.*PYTHONPATH"):
        run_job(job, tmp_path / "x.partial", scheduler=cluster.address)


def test_two_workers_give_what_this_machine_gives(cluster, job, alone, tmp_path):
    cluster.employ("first", "second")
    assert run_job(job, tmp_path / "x.partial", scheduler=cluster.address) == alone


def test_cancelling_keeps_what_is_finished(cluster, job, alone, tmp_path):
    cluster.employ("first", "second")
    with pytest.raises(Cancelled):
        run_job(
            job, tmp_path / "x.partial", scheduler=cluster.address,
            progress=lambda fraction: fraction < 0.2,
        )  # fmt: skip
    assert list((tmp_path / "x.partial").glob("block_*.json"))
    assert run_job(job, tmp_path / "x.partial", scheduler=cluster.address) == alone


def test_a_worker_killed_half_way_changes_nothing(cluster, job, alone, tmp_path):
    cluster.employ("first", "second")
    killed = []

    def kill_one(fraction):
        if fraction > 0.2 and not killed:
            cluster.kill("second")
            killed.append(fraction)
        return True

    results = run_job(job, tmp_path / "x.partial", scheduler=cluster.address, progress=kill_one)
    assert killed
    assert killed[0] < 1
    assert results == alone


def test_data_lost_with_its_worker_is_sent_again(cluster, job, alone):
    """The only worker dies, and another comes: the data goes to that one."""
    cluster.employ("first")
    wanted = {block: range(2 * block, 2 * block + 2) for block in range(COUNT // 2)}
    results = {}
    for block, part in compute_on_cluster(job, wanted, cluster.address, lambda: None):
        results[block] = part
        if len(results) == 3:
            cluster.kill("first")
            cluster.start_worker("third")
    found = [row for block in sorted(results) for row in results[block]]
    np.testing.assert_array_equal(found, alone)


def test_a_scheduler_that_does_not_answer_is_one_sentence(job, tmp_path, monkeypatch):
    from muysc_qgis.survey import cluster as module

    monkeypatch.setattr(module, "_CONNECT_S", 0.5)
    for address in ("tcp://127.0.0.1:1", "nowhere"):
        with pytest.raises(MuyscError, match=f"scheduler {address} does not answer"):
            run_job(job, tmp_path / "x.partial", scheduler=address)


def test_without_dask_it_says_what_to_install(job, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(MuyscError, match="needs the Python library distributed"):
        run_job(job, tmp_path / "x.partial", scheduler="tcp://127.0.0.1:8786")

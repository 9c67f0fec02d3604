"""A survey on an existing Dask cluster."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..errors import MuyscError
from .job import Job

if TYPE_CHECKING:
    from distributed import Client, Future

#: How long (s) the scheduler may take to answer.
_CONNECT_S = 10.0
#: How often (s) the caller may stop the work.
_PULSE_S = 0.2
#: How often the data may be lost with the workers that held it.
_LOSSES = 3

#: Module on the workers.
_MODULE = "muysc_qgis.survey.job"
_REMEDY = (
    "install the same version of the plugin where the workers run and start them with "
    "PYTHONPATH set to its folder"
)


def compute_on_cluster(
    job: Job,
    blocks: Mapping[int, Sequence[int]],
    address: str,
    pulse: Callable[[], None],
) -> Iterator[tuple[int, list[Any]]]:
    """Compute blocks of a job on the workers of a Dask scheduler, in any order.

    The data goes to every worker once. Blocks of a worker that dies are given to others.

    Parameters
    ----------
    job
        What to compute.
    blocks
        Items by block.
    address
        Of the scheduler, such as ``tcp://127.0.0.1:8786``.
    pulse
        Called several times a second; stops the work by an exception.

    Yields
    ------
    tuple
        Block and the results of its items.

    Raises
    ------
    MuyscError
        If distributed is missing, the scheduler cannot be reached, it has no workers, a
        worker cannot work, or an item cannot be computed.
    """
    client = _connect(address)
    try:
        _check_workers(client, address)
        left = dict(blocks)
        for _ in range(_LOSSES):
            for block, results in _results(client, job, left, pulse):
                del left[block]
                yield block, results
            if not left:
                return
            _check_workers(client, address)
        raise MuyscError(
            f"The workers of {address} were lost {_LOSSES} times; check their logs and run again "
            "to go on from the finished parts."
        )
    finally:
        client.close()


def _connect(address: str) -> Client:
    try:
        from distributed import Client
    except ImportError as error:
        raise MuyscError(
            "SCHEDULER needs the Python library distributed, which is missing; install it for the "
            "Python of QGIS (python3-distributed on Debian, “python -m pip install distributed” "
            "elsewhere), or leave SCHEDULER empty for this machine."
        ) from error
    try:
        # A client that finds nobody keeps trying behind the scenes: a plain connection first.
        host, _, port = address.rpartition("://")[2].rpartition(":")
        socket.create_connection((host.strip("[]"), int(port)), _CONNECT_S).close()
        return Client(address, timeout=_CONNECT_S, set_as_default=False)
    except (OSError, ValueError) as error:
        raise MuyscError(
            f"The Dask scheduler {address} does not answer; check the address, such as "
            "tcp://127.0.0.1:8786, and that it is running."
        ) from error


def _check_workers(client: Client, address: str) -> None:
    """Refuse a cluster without workers, or one on which the library is missing or another."""
    versions = client.run(_version_function())
    if not versions:
        raise MuyscError(
            f"The Dask scheduler {address} has no workers; start at least one, such as “dask "
            f"worker {address}”."
        )
    for worker, version in versions.items():
        if version != __version__:
            found = "cannot find the plugin" if version is None else f"has its version {version}"
            raise MuyscError(
                f"The Dask worker {worker} {found} and this is version {__version__}; {_REMEDY}."
            )


def _results(
    client: Client, job: Job, blocks: Mapping[int, Sequence[int]], pulse: Callable[[], None]
) -> Iterator[tuple[int, list[Any]]]:
    """Yield blocks as they are finished; ends early where the data was lost."""
    plain = {
        "function": job.function,
        "settings": dict(job.settings),
        "arrays": dict(job.arrays),
        "items": job.items,
        "fingerprint": job.fingerprint,
    }
    # In a list, because a dictionary would be taken apart.
    (data,) = client.scatter([plain], broadcast=True, hash=False)
    compute = _compute_function()
    futures = {
        client.submit(compute, data, list(items), pure=False): block
        for block, items in blocks.items()
    }
    try:
        while futures:
            pulse()
            done = [future for future in futures if future.status != "pending"]
            if not done:
                time.sleep(_PULSE_S)
            for future in done:
                if future.status in ("lost", "cancelled"):
                    return
                yield futures.pop(future), _result(future)
    finally:
        client.cancel([*futures, data])  # what is left of them


def _result(future: Future) -> list[Any]:
    error = future.exception()
    if error is None:
        answer: dict[str, Any] = future.result()
        if "error" in answer:
            raise MuyscError(answer["error"])
        results: list[Any] = answer["results"]
        return results
    if isinstance(error, ImportError):
        raise MuyscError(f"A Dask worker cannot work ({error}); {_REMEDY}.") from error
    raise MuyscError(
        f"The Dask workers could not compute a part ({error}); check their logs and memory, and "
        "run again to go on from the finished parts."
    ) from error


# What workers run is sent as code, because the plugin may have another name here than there.


def _compute_function() -> Callable[..., Any]:
    module = _MODULE

    def compute(plain: Mapping[str, Any], items: Sequence[int]) -> Any:
        from importlib import import_module

        return import_module(module).answer_elsewhere(plain, items)

    return compute


def _version_function() -> Callable[[], str | None]:
    package = _MODULE.split(".")[0]

    def version() -> str | None:
        from importlib import import_module

        try:
            return str(import_module(package).__version__)
        except ImportError:
            return None

    return version

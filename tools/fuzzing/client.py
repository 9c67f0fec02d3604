"""The other end of `worker`: sends cases, and notices when their process dies or hangs."""

from __future__ import annotations

import contextlib
import json
import select
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

#: Time after which a case is asked to stop, and after which it counts as hanging.
PATIENCE_S = 5.0
LIMIT_S = 90.0
_START_S = 120.0


class Client:
    """A worker that is started again whenever a case has killed it."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._errors = folder / "worker.log"
        self._process: subprocess.Popen[str] | None = None
        self.catalogue: dict[str, list[dict[str, Any]]] = self._start()

    def _start(self) -> Any:
        profile = self._folder / "profile"
        profile.mkdir(exist_ok=True)
        with self._errors.open("w") as errors:
            self._process = subprocess.Popen(  # noqa: S603 - our own module
                [sys.executable, "-m", "tools.fuzzing.worker", str(profile)],
                cwd=Path(__file__).parents[2],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                text=True,
            )
        told = self._answer(_START_S)
        if isinstance(told, str):
            raise RuntimeError(f"QGIS cannot be started: {told}")
        return told

    def _answer(self, seconds: float) -> Any:
        """Return the next answer, or a text that says why there is none."""
        ready, _, _ = select.select([self._process.stdout], [], [], seconds)
        line = self._process.stdout.readline() if ready else ""
        if line:
            return json.loads(line)
        how = "died" if ready else f"did not end within {seconds:g} s"
        if not ready:
            # It writes where it stands, then dies.
            self._process.send_signal(signal.SIGABRT)
        self.stop()
        return f"The process {how}:\n{self._errors.read_text(errors='replace')[-6000:]}"

    def run(self, algorithm: str, parameters: dict[str, Any]) -> dict[str, Any]:
        """Return how a case ended: done, refused or broken."""
        if self._process is None:
            self._start()
        case = {"algorithm": algorithm, "parameters": parameters, "patience_s": PATIENCE_S}
        before = self._errors.stat().st_size
        self._process.stdin.write(json.dumps(case) + "\n")
        self._process.stdin.flush()
        told = self._answer(LIMIT_S)
        if isinstance(told, str):
            return {"end": "broken", "sentence": told}
        # What fails where only QGIS calls it is printed and else goes unseen.
        printed = self._errors.read_bytes()[before:].decode(errors="replace")
        if "Traceback" in printed:
            told["complaints"].append(printed)
        return told

    def stop(self) -> None:
        """End the process."""
        if self._process is None:
            return
        try:
            self._process.wait(2)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            with contextlib.suppress(BrokenPipeError):
                pipe.close()
        self._process = None

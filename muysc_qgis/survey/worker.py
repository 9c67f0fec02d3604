"""A worker process: `python -m muysc_qgis.survey.worker FOLDER`, started by `local`.

Reads the numbers of the items to compute, a JSON list a line, and answers each with a line
of JSON: ``{"results": […]}``, or ``{"error": "sentence"}`` if they cannot be computed. It
ends with its input, so that no worker outlives what started it.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

from .job import Job, answer


def main(folder: str) -> None:
    """Answer until the input ends."""
    # Whatever a library prints goes to the log, not between the answers.
    with os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8") as answers:
        os.dup2(sys.stderr.fileno(), sys.stdout.fileno())

        def tell(content: dict[str, Any]) -> None:
            answers.write(json.dumps(content) + "\n")
            answers.flush()

        compute = Job.load(Path(folder)).prepared()
        tell({"ready": True})
        for line in sys.stdin:
            tell(answer(compute, json.loads(line)))


if __name__ == "__main__":
    main(sys.argv[1])

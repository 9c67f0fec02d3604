"""Run cases for `client`, in a process that may crash or hang without harm.

A line of JSON comes in for each case and one goes out for what became of it. The first
line that goes out is the catalogue of the algorithms.
"""

from __future__ import annotations

import faulthandler
import json
import os
import resource
import sys
import threading
import traceback
import warnings
from pathlib import Path
from typing import Any

from ..declared import load_provider, start_qgis

#: Enough for every sane case; a header that promises more must end in a sentence.
MEMORY_BYTES = 8 * 2**30


def offline_qgis(profile: Path) -> Any:
    """Return QGIS without windows, which reaches no network."""
    from qgis.core import QgsNetworkAccessManager
    from qgis.PyQt.QtNetwork import QNetworkProxy

    os.environ.update(HOME=str(profile), XDG_CACHE_HOME=str(profile / "cache"))
    application = start_qgis(str(profile))
    nowhere = QNetworkProxy(QNetworkProxy.ProxyType.HttpProxy, "127.0.0.1", 1)
    QgsNetworkAccessManager.instance().setFallbackProxyAndExcludes(nowhere, [], [])
    return application


def described(definition: Any) -> dict[str, Any]:
    """Return what a strategy needs to know about a parameter."""
    told = {
        "name": definition.name(),
        "type": definition.type(),
        "optional": bool(definition.flags() & definition.Flag.FlagOptional),
        "default": plain(definition.defaultValue()),
    }
    if definition.type() == "number":
        told["low"], told["high"] = definition.minimum(), definition.maximum()
        told["whole"] = definition.dataType() == definition.Type.Integer
    elif definition.type() == "enum":
        told["options"], told["several"] = definition.options(), definition.allowMultiple()
    elif definition.type() == "file":
        told["folder"] = definition.behavior() == definition.Behavior.Folder
    elif definition.type() == "fileDestination":
        told["filter"] = definition.fileFilter()
    return told


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it, by its text where it cannot."""
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value if isinstance(value, (str, int, float, bool, type(None))) else repr(value)


def execute(algorithm: Any, *arguments: Any) -> dict[str, Any]:
    """Run an algorithm so that an exception of Python arrives as it was raised."""
    from qgis.core import QgsProcessingException, QgsProcessingModelAlgorithm

    if not isinstance(algorithm, QgsProcessingModelAlgorithm):
        return algorithm.processAlgorithm(*arguments)
    results, fine = algorithm.run(*arguments)
    if not fine:
        # The step that failed speaks first, then the model of it.
        raise QgsProcessingException(arguments[-1].errors[0])
    return results


class Runner:
    """Runs one case after another."""

    def __init__(self, provider: Any) -> None:
        self._provider = provider  # models find no algorithms without it
        self._algorithms = {one.name(): one for one in provider.algorithms()}

    def catalogue(self) -> dict[str, list[dict[str, Any]]]:
        """Return the parameters by algorithm."""
        return {
            name: [described(one) for one in algorithm.parameterDefinitions()]
            for name, algorithm in self._algorithms.items()
        }

    def run(self, case: dict[str, Any]) -> dict[str, Any]:
        """Return how a case ended: done, refused with a sentence, or broken."""
        from qgis.core import QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

        class Feedback(QgsProcessingFeedback):
            def __init__(self) -> None:
                super().__init__(False)
                self.errors: list[str] = []
                self.warnings: list[str] = []

            def reportError(self, text: str, fatalError: bool = False) -> None:  # noqa: N802, N803
                self.errors.append(text)

            def pushWarning(self, text: str) -> None:  # noqa: N802
                self.warnings.append(text)

        algorithm = self._algorithms[case["algorithm"]].create()
        context, feedback = QgsProcessingContext(), Feedback()
        # Long is no fault where stopping works, so everything long is stopped.
        stop = threading.Timer(case["patience_s"], feedback.cancel)
        stop.start()
        told: dict[str, Any] = {"end": "done", "sentence": "", "results": {}, "complaints": []}
        try:
            with warnings.catch_warnings(record=True) as raised:
                warnings.simplefilter("always")
                try:
                    fine, said = algorithm.checkParameterValues(case["parameters"], context)
                    if fine:
                        found = execute(algorithm, case["parameters"], context, feedback)
                        algorithm.postProcess(context, feedback)
                        told["results"] = {name: plain(value) for name, value in found.items()}
                    else:
                        told.update(end="refused", sentence=said)
                except QgsProcessingException as error:
                    told.update(end="refused", sentence=str(error))
                except BaseException:
                    told.update(end="broken", sentence=traceback.format_exc())
                told["complaints"] = [
                    f"{one.category.__name__}: {one.message} ({one.filename}:{one.lineno})"
                    for one in raised
                    if not issubclass(one.category, (DeprecationWarning, ResourceWarning))
                ]
        finally:
            stop.cancel()
        told["warnings"] = feedback.warnings
        return told


def main() -> None:
    """Answer cases until there are no more."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    # Whatever else is printed must not come between the answers.
    os.dup2(2, 1)
    faulthandler.enable()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    application = offline_qgis(Path(sys.argv[1]))
    runner = Runner(load_provider())
    print(json.dumps(runner.catalogue()), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(runner.run(json.loads(line))), file=answers, flush=True)
    del application
    # What QGIS tears down at the end is no part of the cases.
    os._exit(0)


if __name__ == "__main__":
    main()

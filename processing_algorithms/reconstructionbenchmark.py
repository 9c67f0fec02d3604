"""Reconstruction methods on a head whose image is known."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputString,
    QgsProcessingParameterDefinition,
)

from ..muysc_qgis.staging import Staging
from ..muysc_qgis.tomography.method_comparison import (
    ANGLES,
    COLUMNS,
    COMPARABLE,
    NOISES,
    SIZES,
    check_setting,
    compare_methods,
    rows,
)
from ..muysc_qgis.tomography.solvers import Options
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.tables import stage_table, table_destination, table_layer
from .parameters.values import (
    choices,
    given,
    number,
    read_choices,
    read_count,
    read_number,
    read_optional,
)


@dataclass(frozen=True)
class _Inputs:
    size: int
    angles: int
    methods: list[str]
    options: Options
    noise_percent: float


class ReconstructionBenchmark(MuyscAlgorithm):
    """Every method on the Shepp–Logan head: error, time and picture."""

    NAME = "reconstructionbenchmark"
    TITLE = "Compare reconstruction methods"
    GROUP = "Tomography"
    GROUP_ID = "tomography"
    TAGS = ("tomography", "reconstruction", "Shepp-Logan", "phantom", "benchmark")
    NUMBERS = (
        ("BEST_ERROR", "Smallest relative error"),
        ("BEST_SECONDS", "Time of that method (s)"),
        ("GREY_ERROR", "Relative error of one grey level"),
        ("MATRIX_SECONDS", "Time of the ray paths, once for all (s)"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            number(
                "SIZE", "Pixels along an edge",
                f"Give the edge of the square image in pixels, {SIZES[0]} to {SIZES[1]}. Time and "
                "memory grow with its square.",
                128, *SIZES, whole=True,
            ),
            number(
                "ANGLES", "Projections",
                f"Give the number of parallel projections, evenly spaced over 180°, {ANGLES[0]} to "
                f"{ANGLES[1]}.",
                180, *ANGLES, whole=True,
            ),
            choices(
                "METHODS", "Methods",
                "Methods to compare. fbp and gridrec need parallel projections and so exist here "
                "alone; all others serve muograms too.",
                list(COMPARABLE), list(COMPARABLE),
            ),
            number(
                "NOISE", "Noise (%)",
                "Give the standard deviation of the projections' errors in percent of the largest "
                f"projection, {NOISES[0]:g} to {NOISES[1]:g}.",
                0.0, *NOISES,
            ),
            number(
                "ITERATIONS", "Iterations (empty: each method's own)",
                "Give the most iterations of every method, 1 or more; a sweep over all rays is "
                "one. Methods that converge sooner end sooner.",
                None, 1, whole=True,
            ),
            number(
                "RELAXATION", "Relaxation (empty: each method's own)",
                "Give the share of each correction that art, bart, sart and sirt apply, above 0 "
                "and below 2.",
                None, 0, 2, advanced=True,
            ),
            number(
                "REGULARIZATION", "Regularisation (empty: each method's own)",
                "Give the strength of the penalty on rough images, 0 or more; at 1 a step between "
                "neighbours weighs as much as the misfit of a pixel.",
                None, 0, advanced=True,
            ),
            number(
                "SEED", "Seed of the noise",
                "Give a whole number, 0 or more; the same seed draws the same noise.",
                1, 0, advanced=True, whole=True,
            ),
            table_layer(
                "TABLE", "Table of methods",
                "CSV: iterations, seconds, errors and misfit of every method.",
            ),
            *document_outputs(
                "Picture of the head and every reconstruction, of error against time and of misfit "
                "against iterations.",
                "One HTML file with the panel, parameters, numbers and how to cite.",
            ),
        ]  # fmt: skip

    def declare_outputs(self) -> None:
        self.addOutput(QgsProcessingOutputString("BEST_METHOD", "Method of the smallest error"))
        super().declare_outputs()

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        size = read_count(self, parameters, "SIZE", context)
        angles = read_count(self, parameters, "ANGLES", context)
        methods = read_choices(self, parameters, "METHODS", context)
        noise = read_number(self, parameters, "NOISE", context)
        check_setting(size, angles, methods, noise)
        options = Options(
            iterations=read_count(self, parameters, "ITERATIONS", context)
            if given(parameters, "ITERATIONS")
            else None,
            relaxation=read_optional(self, parameters, "RELAXATION", context),
            regularization=read_optional(self, parameters, "REGULARIZATION", context),
            seed=read_count(self, parameters, "SEED", context),
        )
        return _Inputs(size, angles, methods, options, noise)

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        table = table_destination(self, parameters, "TABLE", context)
        comparison = compare_methods(
            inputs.size,
            inputs.angles,
            inputs.methods,
            inputs.options,
            inputs.noise_percent,
            progress_of(feedback, 0.0, 0.9),
        )
        for one in comparison.results:
            feedback.pushInfo(
                f"{one.method}: relative error {one.relative_error:.4f} after {one.iterations} "
                f"iterations in {one.seconds:.3g} s"
            )
        for warning in comparison.warnings:
            feedback.pushWarning(warning)
        results: dict[str, Any] = {}
        if table is not None:
            stage_table(staging, table, COLUMNS, rows(comparison))
            results["TABLE"] = table
        results |= stage_drawn(
            self,
            lambda: _drawing().method_panel(comparison),
            lambda provenance: _drawing().report(comparison, provenance),
            results, parameters, context, feedback, staging, (),
        )  # fmt: skip
        best = comparison.best
        return results | {
            "BEST_METHOD": best.method,
            "BEST_ERROR": best.relative_error,
            "BEST_SECONDS": best.seconds,
            "GREY_ERROR": comparison.grey_error,
            "MATRIX_SECONDS": comparison.matrix_seconds,
        }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots.tomography import method_documents

    return method_documents

"""Write the models that come with the provider, from the algorithms they chain.

Needs QGIS 3.22; run as ``make models`` after a change of the parameters that they take over.
Inputs are those of the algorithms, with name, help, range and default. Later versions write
models whose outputs are named after their titles, which are translated.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingProvider,
)
from qgis.PyQt.QtCore import QPointF, QSizeF

from .declared import ROOT, load_provider, start_qgis

FOLDER = ROOT / "processing_algorithms" / "models"
GROUP = "Models"
#: Places in the designer: inputs above, then a row for each step.
COLUMN, ROW = 240, 170
#: The designer shows nothing left of or above its corner.
LEFT, UP = 160, 90
#: Width and height of an input, for a label of two lines.
BOX = (205, 42)
INPUTS_IN_A_ROW = 5


@dataclass(frozen=True)
class Step:
    """One algorithm of a model.

    Attributes
    ----------
    name
        What the step is called, and the first half of its outputs' names.
    algorithm
        Its id without the provider's.
    title
        What the designer shows.
    inputs
        Parameters that are inputs of the model, under the same names.
    outputs
        Titles of what the model hands over, by output.
    wired
        Step and output by parameter.
    """

    name: str
    algorithm: str
    title: str
    inputs: tuple[str, ...]
    outputs: dict[str, str]
    wired: dict[str, tuple[str, str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Model:
    """A chain of steps, with its help."""

    title: str
    help: str
    steps: tuple[Step, ...]

    @property
    def file(self) -> Path:
        """Return where it is kept; the file's name is its id."""
        return FOLDER / f"{self.title.lower().replace(' ', '')}.model3"


TERRAIN = ("DEM", "BAND")
SIGHT = ("DETECTOR", "DETECTOR_HEIGHT", "TARGET", "TARGET_HEIGHT")
ROCK = ("MATERIAL", "DENSITY", "FLUX_MODEL")


def _drape(name: str, title: str, output: str, source: tuple[str, str]) -> Step:
    return Step(name, "drape", title, TERRAIN, {"OUTPUT": output}, {"MUOGRAM": source})


MODELS = (
    Model(
        "Volcano survey",
        "<p>From an elevation model, a detector and a target to maps: simulates the muograms of "
        "the field of view and drapes thickness and flux on the terrain that the detector sees. "
        "All layers arrive with their colours, and the report tells the rest.</p>",
        (
            Step(
                "radiography", "radiography", "Simulate the muograms",
                (
                    *TERRAIN, *SIGHT, "AZIMUTH_APERTURE", "ELEVATION_APERTURE", "AZIMUTH_PIXELS",
                    "ELEVATION_PIXELS", *ROCK, "ACCEPTANCE", "MUONS",
                ),
                {
                    "THICKNESS": "Rock thickness", "FLUX": "Muon flux",
                    "EXPOSURE": "Exposure time", "FIELD_OF_VIEW": "Field of view",
                    "REPORT": "Report",
                },
            ),
            _drape(
                "thickness", "Drape the thickness", "Rock thickness on the terrain",
                ("radiography", "THICKNESS"),
            ),
            _drape("flux", "Drape the flux", "Muon flux on the terrain", ("radiography", "FLUX")),
        ),
    ),
    Model(
        "Exposure plan",
        "<p>Answers how long a telescope has to count: expected counts, days of exposure and the "
        "smallest visible density contrast along its trajectories, and the last two draped on the "
        "terrain that it sees.</p>",
        (
            Step(
                "telescope", "expectedcounts", "Count the muons",
                (*TERRAIN, *SIGHT, "PRESET", "DAYS", "MUONS", "SIGMA", "CONTRAST", "MERGE", *ROCK),
                {
                    "COUNTS": "Muon counts", "EXPOSURE": "Exposure time",
                    "DENSITY_RESOLUTION": "Smallest visible density contrast",
                    "TABLE": "Table of trajectories", "REPORT": "Report",
                },
            ),
            _drape(
                "exposure", "Drape the exposure", "Exposure time on the terrain",
                ("telescope", "EXPOSURE"),
            ),
            _drape(
                "contrast", "Drape the contrast", "Smallest visible contrast on the terrain",
                ("telescope", "DENSITY_RESOLUTION"),
            ),
        ),
    ),
)  # fmt: skip


def build(model: Model, provider: QgsProcessingProvider) -> QgsProcessingModelAlgorithm:
    """Return a model as QGIS knows it.

    Raises
    ------
    ValueError
        If QGIS finds something wrong with a step.
    """
    built = QgsProcessingModelAlgorithm(model.title, GROUP)
    names = list(dict.fromkeys(name for step in model.steps for name in step.inputs))
    for number, name in enumerate(names):
        step = next(one for one in model.steps if name in one.inputs)
        place = QgsProcessingModelParameter(name)
        place.setSize(QSizeF(*BOX))
        place.setPosition(
            QPointF(
                LEFT + number % INPUTS_IN_A_ROW * COLUMN,
                UP + number // INPUTS_IN_A_ROW * ROW / 2,
            )
        )
        declared = provider.algorithm(step.algorithm).parameterDefinition(name)
        built.addModelParameter(declared.clone(), place)
    built.setParameterOrder(names)
    needed = {source for step in model.steps for source in step.wired.values()}
    first_row = UP + (len(names) // INPUTS_IN_A_ROW + 1) * ROW / 2 + ROW
    for number, step in enumerate(model.steps):
        place = QPointF(LEFT + number * 2.2 * COLUMN, first_row)
        child = _child(step, provider.algorithm(step.algorithm), place)
        child.setModelOutputs(dict(_outputs(step, place, needed)))
        built.addChildAlgorithm(child)
    helps = {"ALG_DESC": model.help}
    helps |= {name: built.parameterDefinition(name).help() for name in names}
    helps |= {
        f"{step.name}:{name}": provider.algorithm(step.algorithm).parameterDefinition(name).help()
        for step in model.steps
        for name in step.outputs
    }
    built.setHelpContent(helps)
    built.updateDestinationParameters()
    for step in model.steps:
        fine, problems = built.validateChildAlgorithm(step.name)
        if not fine:
            raise ValueError(f"{model.title}, {step.name}: {problems}")
    return built


def _child(
    step: Step, declared: QgsProcessingAlgorithm, position: QPointF
) -> QgsProcessingModelChildAlgorithm:
    child = QgsProcessingModelChildAlgorithm(f"muysc:{step.algorithm}")
    child.setChildId(step.name)
    child.setDescription(step.title)
    child.setPosition(position)
    source = QgsProcessingModelChildParameterSource
    for name in step.inputs:
        child.addParameterSources(name, [source.fromModelParameter(name)])
    # The rest is fixed; the designer takes no step with a value missing.
    for one in declared.parameterDefinitions():
        free = one.name() in (*step.inputs, *step.wired) or one.isDestination()
        if not free and not one.flags() & one.Flag.FlagOptional:
            child.addParameterSources(one.name(), [source.fromStaticValue(one.defaultValue())])
    for name, (other, output) in step.wired.items():
        child.addParameterSources(name, [source.fromChildOutput(other, output)])
    return child


def _outputs(
    step: Step, position: QPointF, needed: set[tuple[str, str]]
) -> Iterable[tuple[str, QgsProcessingModelOutput]]:
    for number, (name, title) in enumerate(step.outputs.items()):
        output = QgsProcessingModelOutput(name, title)
        output.setChildId(step.name)
        output.setChildOutputName(name)
        # A later step fails without it, even where nobody wants to keep it.
        output.setMandatory((step.name, name) in needed)
        output.setPosition(position + QPointF(COLUMN, (number + 1) * ROW / 2))
        yield name, output


def main() -> None:
    """Write every model."""
    with tempfile.TemporaryDirectory() as profile:
        application = start_qgis(profile)
        provider = load_provider()
        for model in MODELS:
            build(model, provider).toFile(str(model.file))
            print(f"Wrote {model.file.relative_to(ROOT)}.")
        del application


if __name__ == "__main__":
    main()

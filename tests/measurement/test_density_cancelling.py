"""A density is stopped between blocks of rays, long before a step of it is done."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled
from muysc_qgis.muogram import Muogram
from muysc_qgis.radiography import batches, inversion, transmission
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.workflows.measured import Measurement
from muysc_qgis.workflows.measured_density import DensityChoices, density_behind

AZIMUTH, ELEVATION = np.linspace(0.0, 60.0, 40), np.linspace(35.0, 3.0, 30)
PLACE = {"DETECTOR_ELEVATION": 300.0, "DAYS": 30.0, "ACCEPTANCE": 8.0}
#: Rays in a block here, two blocks for all.
BLOCK = 600


def muogram(quantity, values):
    return Muogram(quantity, values, AZIMUTH, ELEVATION, PLACE)


@pytest.fixture(scope="module")
def thickness():
    return np.clip(28.0 - ELEVATION, 0.0, None)[:, None] * np.full(len(AZIMUTH), 45.0)


@pytest.fixture(scope="module")
def counts(thickness):
    physics = Physics()
    flux = transmission.attenuate(thickness * 220.0, ELEVATION[:, None], physics, 300.0).flux
    return np.random.default_rng(3).poisson(flux * 240.0).astype(float)


@pytest.fixture
def rays(monkeypatch):
    """Rays whose opacity or flux was asked for, block by block."""
    sizes = []
    monkeypatch.setattr(batches, "_BLOCK", BLOCK)
    for module, name in ((inversion, "_search"), (transmission, "minimum_energy")):
        own = getattr(module, name)

        def counted(values, *others, own=own):
            sizes.append(values.size)
            return own(values, *others)

        monkeypatch.setattr(module, name, counted)
    return sizes


def density(counts, thickness, minimum, progress):
    choices = DensityChoices(minimum_counts=minimum, model_spread=True)
    measured = Measurement(muogram("counts", counts))
    return density_behind(measured, muogram("thickness", thickness), Physics(), choices, 300.0,
                          progress)  # fmt: skip


def test_every_block_is_asked_before_and_the_bar_only_moves_on(counts, thickness, rays):
    told = []
    density(counts, thickness, 0.0, lambda share: told.append(share) or True)
    assert told == sorted(told)
    assert told[0] == 0.0
    assert told[-1] == 1.0
    assert max(rays) <= BLOCK
    # Rays too thin to matter are found once for each model without asking.
    assert len(rays) - len(told) <= 2 * 7


@pytest.mark.parametrize("minimum", [0.0, 30.0])
@pytest.mark.parametrize("allowed", [1, 4, 11, 60])
def test_no_block_is_begun_after_a_stop(counts, thickness, rays, minimum, allowed):
    told = []

    def stop_after(share):
        told.append(len(rays))
        return len(told) <= allowed

    with pytest.raises(Cancelled):
        density(counts, thickness, minimum, stop_after)
    assert len(told) == allowed + 1
    assert len(rays) == told[-1]
    assert all(later - earlier <= 2 for earlier, later in zip(told, told[1:]))

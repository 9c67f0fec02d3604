"""Known models against closed forms."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.phantoms import (
    SHEPP_LOGAN,
    Ellipse,
    checkerboard,
    conduit,
    ellipse_image,
    ellipse_projections,
    share_inside,
    sphere,
    with_body,
)
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((-100, -100, 0), (10, 10, 10), (20, 20, 20))


def test_the_head_has_its_areas():
    """Σ value · π a b over the square of area 4."""
    expected = sum(one.value * np.pi * one.a * one.b for one in SHEPP_LOGAN) / 4
    assert ellipse_image(SHEPP_LOGAN, 128).mean() == pytest.approx(expected, rel=2e-3)


def test_the_head_has_its_values():
    """Skull 1, brain 0.2, ventricles 0, the sum of the ellipses that cover a point."""
    image = ellipse_image(SHEPP_LOGAN, 200)

    def at(x, y):
        return image[int((x + 1) * 100), int((y + 1) * 100)]

    assert at(0.0, 0.895) == pytest.approx(1.0)
    assert at(0.0, -0.3) == pytest.approx(0.2)
    assert at(0.22, 0.0) == pytest.approx(0.0, abs=1e-6)
    assert at(0.0, 0.45) == pytest.approx(0.3)
    assert at(0.9, 0.9) == 0.0


def test_projections_of_a_turned_ellipse_against_sampling():
    one = (Ellipse(2.0, 0.6, 0.3, 0.1, -0.2, 25.0),)
    offset, angles = np.linspace(-0.9, 0.9, 37), np.array([0.0, 30.0, 115.0])
    along = (np.arange(40000) + 0.5) / 10000 - 2
    turn = np.radians(25.0)
    for angle, projection in zip(np.radians(angles), ellipse_projections(one, angles, offset)):
        for s, value in zip(offset, projection):
            x = s * np.cos(angle) - along * np.sin(angle) - 0.1
            y = s * np.sin(angle) + along * np.cos(angle) + 0.2
            inside = ((x * np.cos(turn) + y * np.sin(turn)) / 0.6) ** 2 + (
                (y * np.cos(turn) - x * np.sin(turn)) / 0.3
            ) ** 2 <= 1
            assert value == pytest.approx(2.0 * inside.sum() / 10000, abs=5e-4)


def test_bodies_have_their_volumes():
    """4/3 π r³, π r² h and half the space."""
    ball = share_inside(GRID, sphere((5, -3, 90), 60))
    assert ball.sum() * GRID.volume_m3 == pytest.approx(4 / 3 * np.pi * 60**3, rel=5e-3)
    pipe = share_inside(GRID, conduit((5, -3), 40, 30, 160))
    assert pipe.sum() * GRID.volume_m3 == pytest.approx(np.pi * 40**2 * 130, rel=5e-3)
    assert not pipe[:, :, :3].any()
    assert share_inside(GRID, checkerboard((-100, -100, 0), 50)).mean() == pytest.approx(0.5)


def test_the_checkerboard_alternates():
    board = share_inside(GRID, checkerboard((-100, -100, 0), 50))
    assert board[0, 0, 0] == 0
    assert board[5, 0, 0] == board[0, 5, 0] == board[0, 0, 5] == 1
    assert board[5, 5, 0] == 0


def test_densities_mix_by_share():
    share = np.array([0.0, 0.25, 1.0])
    assert with_body(2.0, share, 3.0) == pytest.approx([2.0, 2.25, 3.0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: sphere((0, 0, 0), 0), "radius of the sphere is 0 m"),
        (lambda: conduit((0, 0), 5, 10, 10), "height of the conduit is 0 m"),
        (lambda: checkerboard((0, 0, 0), -1), "edge of the checkerboard is -1 m"),
    ],
)
def test_empty_bodies_are_refused(make, message):
    with pytest.raises(MuyscError, match=message):
        make()

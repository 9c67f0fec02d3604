"""Parallel beams: paths, filtered back-projection and Gridrec."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.tomography.figures_of_merit import relative_error
from muysc_qgis.tomography.method_comparison import (
    COLUMNS,
    COMPARABLE,
    check_setting,
    compare_methods,
    rows,
)
from muysc_qgis.tomography.parallel_beam import DIRECT, ParallelBeam, fbp, gridrec
from muysc_qgis.tomography.phantoms import (
    SHEPP_LOGAN,
    Ellipse,
    ellipse_image,
    ellipse_projections,
)
from muysc_qgis.tomography.projector import path_matrix
from muysc_qgis.tomography.solvers import Options


def projections_of(ellipses, beam):
    scaled = beam.offset * 2 / beam.size
    return ellipse_projections(ellipses, beam.angle_deg, scaled) * beam.size / 2


def test_paths_project_the_head_as_the_closed_form_does():
    """The finer the pixels, the nearer: order ½ in this norm, as the edges are steps."""
    errors = []
    for size in (32, 64, 128):
        beam = ParallelBeam.around(size, 12)
        image = ellipse_image(SHEPP_LOGAN, size)
        projected = path_matrix(beam.paths()) @ image.ravel()
        errors.append(relative_error(projected.reshape(12, -1), projections_of(SHEPP_LOGAN, beam)))
    assert errors[0] > 1.35 * errors[1] > 1.35**2 * errors[2]
    assert errors[2] < 0.06


@pytest.mark.parametrize("direct", [fbp, gridrec])
def test_a_disc_comes_back_with_its_value(direct):
    """Off the centre, where mirrored or turned images would show."""
    disc = (Ellipse(1.5, 0.3, 0.3, 0.35, -0.2, 0.0),)
    beam = ParallelBeam.around(96, 150)
    image = direct(beam, projections_of(disc, beam))
    x = (beam.centres * 2 / 96)[:, None] - 0.35
    y = (beam.centres * 2 / 96)[None, :] + 0.2
    inside = np.hypot(x, y)
    assert image[inside < 0.22].mean() == pytest.approx(1.5, rel=5e-3)
    # The edge, which no band-limited image has, rings by a few hundredths.
    assert np.abs(image[inside < 0.22] - 1.5).max() < 0.1
    assert np.abs(image[inside > 0.4]).mean() < 0.02


@pytest.mark.parametrize("direct", [fbp, gridrec])
@pytest.mark.parametrize(("size", "detectors"), [(40, 57), (41, 58), (40, 30)])
def test_both_are_the_same_sum_over_filtered_projections(direct, size, detectors):
    """Against the transforms summed up point by point, up to interpolation."""
    beam = ParallelBeam(size, np.array([0.0, 20.0, 75.0, 130.0]), detectors)
    data = np.random.default_rng(0).random((4, detectors)).cumsum(axis=1) % 7
    transform, length = beam._filtered(data)
    number = np.arange(transform.shape[1])
    twice = np.where((number == 0) | (number == number[-1]), 1, 2)
    expected = np.zeros((size, size))
    for angle, some in zip(np.radians(beam.angle_deg), transform):
        s = beam.centres[:, None] * np.cos(angle) + beam.centres * np.sin(angle) - beam.offset[0]
        wave = np.exp(2j * np.pi * number * s[..., None] / length)
        expected += (wave @ (twice * some)).real / length
    expected *= np.pi / 4
    difference = direct(beam, data) - expected
    assert np.abs(difference).max() < (0.06 if direct is fbp else 2e-3) * np.abs(expected).max()


def test_projections_must_fit_the_beam():
    beam = ParallelBeam.around(16, 5)
    for direct in (fbp, gridrec):
        with pytest.raises(MuyscError, match=r"\(5, 3\) for 5 angles and 23 detectors"):
            direct(beam, np.ones((5, 3)))
    with pytest.raises(MuyscError, match="at least 1, 2 and 2"):
        ParallelBeam.around(1, 5)


def test_every_method_is_compared():
    """On noise-free data each is better than one grey level, the direct ones too."""
    comparison = compare_methods(48, 60, options=Options(regularization=0.01))
    grey = comparison.grey_error
    assert grey == pytest.approx(comparison.truth.std() / np.sqrt(np.mean(comparison.truth**2)))
    assert [result.method for result in comparison.results] == list(COMPARABLE)
    for result in comparison.results:
        assert result.relative_error < 0.55 * grey, result.method
        assert result.seconds > 0
        # Each comes nearer to the projections than the grey level it starts from.
        assert result.method in DIRECT or result.misfit[-1] < 0.5 * result.misfit[0]
    assert comparison.matrix_seconds > 0
    errors = [line[COLUMNS.index("relative_error")] for line in rows(comparison)]
    assert min(errors) == comparison.best.relative_error
    starts = [result.misfit[0] for result in comparison.results if len(result.misfit)]
    assert starts == pytest.approx([starts[0]] * len(starts))


def test_filtered_projections_come_nearer_the_more_projections_there_are():
    errors = [
        relative_error(fbp(beam, projections_of(SHEPP_LOGAN, beam)), ellipse_image(SHEPP_LOGAN, 64))
        for beam in (ParallelBeam.around(64, angles) for angles in (12, 24, 48, 96))
    ]
    assert errors == sorted(errors, reverse=True)
    assert errors[-1] < 0.3 * errors[0]


def test_a_comparison_refuses_what_it_cannot_compare_and_can_be_stopped():
    with pytest.raises(MuyscError, match="“fdk” cannot be compared; choose among art, bart"):
        compare_methods(16, 8, ["fbp", "fdk"])
    with pytest.raises(MuyscError, match="no method to compare"):
        compare_methods(16, 8, [])
    with pytest.raises(MuyscError, match="use at most 613 pixels"):
        check_setting(700, 1120, ["sirt"])
    # What needs no paths needs no memory for them.
    check_setting(700, 1120, ["fbp"])
    with pytest.raises(Cancelled):
        compare_methods(16, 8, ["fbp"], progress=lambda fraction: False)

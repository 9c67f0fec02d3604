"""How near a reconstruction is to the known model."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .voxels import VoxelGrid, view


def relative_error(reconstruction: np.ndarray, truth: np.ndarray) -> float:
    """Return ‖R − T‖₂ / ‖T‖₂ over the values that both know.

    Raises
    ------
    MuyscError
        If the shapes differ, or the known truth is nothing but zeros.
    """
    known = _both_known(reconstruction, truth)
    size = float(np.linalg.norm(truth[known]))
    if size == 0.0:
        raise MuyscError("The known model is 0 everywhere, so that no error is relative to it.")
    return float(np.linalg.norm(reconstruction[known] - truth[known])) / size


@dataclass(frozen=True)
class ViewError:
    """ε = R − T of one view of a volume."""

    #: (…) ε, NaN where a view is unknown.
    difference: np.ndarray
    #: Mean of |ε|.
    mean: float
    #: Standard deviation of |ε|.
    deviation: float


def view_error(
    grid: VoxelGrid,
    reconstruction: np.ndarray,
    truth: np.ndarray,
    name: str,
    *,
    normalised: bool = True,
) -> ViewError:
    """Return the error of the volume summed along an axis.

    Parameters
    ----------
    grid, reconstruction, truth
        Volumes (east, north, up); NaN where there is no rock.
    name
        ``top``, ``front`` or ``side``.
    normalised
        Whether each view is divided by its own largest value, so that shapes are compared;
        otherwise ε is in the values' unit times metres.

    Raises
    ------
    MuyscError
        If the view is unknown, a volume does not fit the grid, or the views share nothing.
    """
    seen, known = view(grid, reconstruction, name), view(grid, truth, name)
    _both_known(seen, known)
    if normalised:
        seen, known = _over_largest(seen), _over_largest(known)
    difference = seen - known
    size = np.abs(difference[np.isfinite(difference)])
    return ViewError(difference, float(size.mean()), float(size.std()))


def contrast_recovered(reconstruction: np.ndarray, truth: np.ndarray, inside: np.ndarray) -> float:
    """Return the contrast of a body against its surroundings over the true one: 1 is perfect.

    Parameters
    ----------
    reconstruction, truth
        Volumes; NaN where there is no rock.
    inside
        Of bool: where the body is.

    Raises
    ------
    MuyscError
        If the body or its surroundings hold no known value, or have the same true density.
    """
    known = _both_known(reconstruction, truth)
    body, around = known & inside, known & ~inside
    if not body.any() or not around.any():
        raise MuyscError(
            f"The body covers {np.count_nonzero(body)} of {np.count_nonzero(known)} known voxels; "
            "choose one that is in the rock of the volume and leaves some of it."
        )
    true = float(truth[body].mean() - truth[around].mean())
    if true == 0.0:
        raise MuyscError("The body is as dense as its surroundings, so that it has no contrast.")
    return float(reconstruction[body].mean() - reconstruction[around].mean()) / true


def _both_known(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    if one.shape != other.shape:
        raise MuyscError(
            f"The models have {one.shape} and {other.shape} values; compare models of one grid."
        )
    known = np.isfinite(one) & np.isfinite(other)
    if not known.any():
        raise MuyscError("The models share no known value; compare models of the same rock.")
    return known


def _over_largest(values: np.ndarray) -> np.ndarray:
    largest = float(np.nanmax(np.abs(values)))
    return values / largest if largest > 0 else values

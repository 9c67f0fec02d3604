"""The choice among candidates: the best ones, and those that go well together."""

from __future__ import annotations

import numpy as np

from ..errors import MuyscError

#: Azimuths around the target (degrees) on which coverage is counted: one a degree.
AZIMUTHS_DEG = np.arange(0.5, 360.0, 1.0)


def best_sites(
    score: np.ndarray, x: np.ndarray, y: np.ndarray, count: int, apart_m: float
) -> np.ndarray:
    """Return the best candidates, best first, none within a distance of a better one.

    Parameters
    ----------
    score
        (n,) larger is better; candidates of 0 or unknown score are left out.
    x, y
        (n,) places in a plane in metres.
    count
        Most that are wanted.
    apart_m
        Smallest distance between two of them.

    Returns
    -------
    numpy.ndarray
        Their indices, `count` of them or fewer.
    """
    chosen: list[int] = []
    for index in np.argsort(-np.nan_to_num(score), kind="stable"):
        if len(chosen) == count or not score[index] > 0:
            break
        others = np.array(chosen, dtype=int)
        if np.all(np.hypot(x[others] - x[index], y[others] - y[index]) >= apart_m):
            chosen.append(int(index))
    return np.array(chosen, dtype=int)


def coverage(azimuth_deg: np.ndarray, score: np.ndarray, width_deg: float) -> np.ndarray:
    """Return how well each azimuth around a target is seen from some sites, (360,).

    max over the sites of score × max(0, 1 − |Δ|/w), where Δ is the angle between the azimuth and
    that of the site, and w the width, at least the degree from one azimuth to the next.

    Parameters
    ----------
    azimuth_deg, score
        (n,) azimuth of each site from the target, and what it is worth.
    width_deg
        Angle beyond which a site says nothing.
    """
    turn = np.abs((AZIMUTHS_DEG[None, :] - azimuth_deg[:, None] + 180.0) % 360.0 - 180.0)
    # Narrower, a site between two azimuths would cover neither.
    width = max(width_deg, 1.0)
    worth = score[:, None] * np.maximum(1.0 - turn / width, 0.0)
    return np.max(worth, axis=0, initial=0.0)


def telescope_set(
    azimuth_deg: np.ndarray, score: np.ndarray, count: int, width_deg: float
) -> tuple[np.ndarray, np.ndarray]:
    """Choose sites that together cover the azimuths around a target best.

    One after the other the site is taken that raises the mean of `coverage` most. The
    mean never falls and gains less the more sites there are, so that this reaches at least
    1 − 1/e of the best set (Nemhauser, Wolsey & Fisher 1978, doi:10.1007/BF01588971).

    Parameters
    ----------
    azimuth_deg, score
        (n,) azimuth of each candidate from the target, and what it is worth.
    count
        Number of telescopes.
    width_deg
        See `coverage`.

    Returns
    -------
    tuple
        Indices in the order of choice, fewer than asked for where no candidate is worth more, and
        the mean coverage after each.

    Raises
    ------
    MuyscError
        If the width is not above 0.
    """
    check_width(width_deg)
    able = _best_of_each_degree(azimuth_deg, score)
    worth = np.array([coverage(azimuth_deg[[one]], score[[one]], width_deg) for one in able])
    covered = np.zeros(len(AZIMUTHS_DEG))
    chosen: list[int] = []
    means: list[float] = []
    while len(chosen) < count and len(able):
        gain = np.maximum(worth - covered, 0.0).sum(axis=1)
        best = int(np.argmax(gain))
        if not gain[best] > 0:
            break
        covered = np.maximum(covered, worth[best])
        chosen.append(int(able[best]))
        means.append(float(covered.mean()))
    return np.array(chosen, dtype=int), np.array(means)


def check_width(width_deg: float) -> None:
    """Refuse an angle to either side of a telescope that covers nothing.

    Raises
    ------
    MuyscError
        If it is not above 0° and up to 360°.
    """
    if not 0 < width_deg <= 360:
        raise MuyscError(
            f"An angle of {width_deg:g}° covers nothing; give degrees above 0 and up to 360."
        )


def _best_of_each_degree(azimuth_deg: np.ndarray, score: np.ndarray) -> np.ndarray:
    """Return the best candidate of each degree: the others cover hardly more."""
    order = np.argsort(np.nan_to_num(score), kind="stable")
    order = order[np.nan_to_num(score[order]) > 0]
    best = np.full(360, -1)
    best[np.floor(azimuth_deg[order] % 360.0).astype(int) % 360] = order
    return best[best >= 0]

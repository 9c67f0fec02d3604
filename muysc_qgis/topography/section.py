"""The terrain along one azimuth, as a section plot shows it."""

from __future__ import annotations

import numpy as np

from .frame import LocalFrame
from .profiles import lay_paths, profile_pieces, reach_m

#: Where each piece between two grid lines is sampled.
_SHARES = np.arange(4) / 4


def terrain_section(
    frame: LocalFrame, eye_m: float, azimuth_deg: float, lowest_elevation_deg: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the terrain under a ray, in the frame in which rays are straight.

    Parameters
    ----------
    frame
        Frame of the detector.
    eye_m
        Height of the detector, in the DEM's heights.
    azimuth_deg
        Direction.
    lowest_elevation_deg
        The section ends where a ray of this elevation is above any mountain.

    Returns
    -------
    tuple
        (n,) increasing horizontal distances (m) and (n,) ground heights (m) less
        the curvature drop, NaN where unknown, at every grid line crossed and at three
        points between each two, along which the terrain is a parabola.
    """
    reach = reach_m(frame, eye_m, float(np.tan(np.radians(lowest_elevation_deg))))
    paths = lay_paths(frame, np.array([azimuth_deg]), 0.0, reach, None)
    distance, ground = [np.empty(0)], [np.empty(0)]
    for pieces in profile_pieces(paths, slice(0, 1), eye_m, frame):
        # Where one piece ends the next begins, so the starts tell it all.
        start, length = pieces.start_m[:, None], (pieces.end_m - pieces.start_m)[:, None]
        s = start + _SHARES * length
        slope = pieces.linear[:, None] + pieces.quadratic[:, None] * s
        distance.append(s.ravel())
        ground.append((eye_m + pieces.constant[:, None] + slope * s).ravel())
    return np.concatenate(distance), np.concatenate(ground)

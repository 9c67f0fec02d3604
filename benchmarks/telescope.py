"""Expected counts in telescopes on Vesuvius, and their acceptances, in one run."""

from __future__ import annotations

from measure import DEM, DETECTOR, ROOT, TARGET, Row, in_fresh_process, print_table, seconds_of

from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import plane_etendue, trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.planning import ON_REQUEST, CountingPlan
from muysc_qgis.telescope.presets import PRESETS
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.expected_counts import TelescopeCounts, expected_counts

#: Telescopes by the limits for their counts.
_LIMITS = {"mute": "limit 0.5 s", "lopresti2020": "limit 4 s"}


def count(name: str, wanted: tuple[str, ...] = ()) -> TelescopeCounts:
    """Return what a telescope counts, from opening the DEM."""
    sight = take_sight(open_dem(DEM), DETECTOR, TARGET)
    pointing = Pointing(sight.boresight_azimuth_deg, sight.boresight_elevation_deg)
    return expected_counts(
        sight, PRESETS[name].geometry, pointing, Physics(), CountingPlan(), wanted=wanted
    )


def time_counts() -> None:
    rows = []
    for name, limit in _LIMITS.items():
        side = 2 * PRESETS[name].geometry.bars_x - 1
        for wanted in ((), ON_REQUEST):
            words = in_fresh_process(
                "from telescope import *\nfrom measure import *\n"
                f"print(seconds_of(lambda: count({name!r}, {wanted!r}), 5), peak_mib())"
            )
            what = "counts and density contrasts" if wanted else "counts"
            rows.append(Row(f"{what}, {side} × {side} trajectories", float(words[0]), limit,
                            float(words[1])))  # fmt: skip
    print_table("From DEM file to counts, exact acceptance included, in process", rows)


def time_acceptances() -> None:
    rows = []
    for name, preset in PRESETS.items():
        error = trajectories(preset.geometry).etendue_cm2_sr / plane_etendue(preset.geometry) - 1
        rows.append(
            Row(name, seconds_of(lambda one=preset.geometry: trajectories(one), 5),
                f"{preset.geometry.trajectories} trajectories; étendue off Sullivan's closed form "
                f"by {abs(error):.0e}")
        )  # fmt: skip
    print_table("Exact acceptance of every trajectory", rows)


if __name__ == "__main__":
    print(f"Benchmarks of {ROOT.name}; medians, warm unless said otherwise")
    time_counts()
    time_acceptances()

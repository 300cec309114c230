# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""One run of the odometry, and its files. Read when asked for: of a large study few are needed."""

import dataclasses
import functools
import math
import pathlib

import numpy as np

from report import run_files, trajectories
from report.run_files import number

TRAJECTORY_NAMES = ("trajectory_tum.txt", "trajectory.tum")


# Of scans.csv: what became of the returns.
RETURN_COLUMNS = (
    "kept", "not_finite", "no_doppler", "out_of_range", "out_of_view", "no_velocity", "moving",
    "occluded", "behind_nearest",
)  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Run:
    """One drive estimated once. Metrics are NaN where the run failed or has no ground truth."""

    sequence: str
    variant: str
    seed: str
    status: str = "ok"
    message: str = ""
    folder: pathlib.Path | None = None
    reference_file: pathlib.Path | None = None
    row: dict = dataclasses.field(default_factory=dict, compare=False)
    timing: dict = dataclasses.field(default_factory=dict, compare=False)
    align: str = "se3"
    plane: str = "xy"

    @property
    def is_ok(self):
        return self.status == "ok"

    @property
    def is_absent(self):
        return self.status == "absent"

    def metric(self, name):
        return number(self.row.get(name)) if self.is_ok else math.nan

    def _first_file(self, names):
        for name in names if self.folder else ():
            if (self.folder / name).is_file():
                return self.folder / name
        return None

    @functools.cached_property
    def estimate(self):
        """N x 8, or None where there is no trajectory."""
        path = self._first_file(TRAJECTORY_NAMES)
        return run_files.read_tum(path) if path else None

    @functools.cached_property
    def reference(self):
        return run_files.read_tum(self.reference_file) if self.reference_file else None

    @functools.cached_property
    def errors(self):
        """PoseErrors, or None where they cannot be had."""
        if self.estimate is None or self.reference is None:
            return None
        try:
            return trajectories.PoseErrors(self.reference, self.estimate, self.align, self.plane)
        except ValueError:
            return None

    @functools.cached_property
    def map_points(self):
        """N x 3 [m] in the frame of the estimate; empty where there is no map."""
        path = self._first_file(("map.ply",))
        return run_files.read_points(path) if path else np.empty((0, 3))

    def ply(self, name):
        """The vertices of a PLY file of the run by property, None where there is no such file."""
        path = self._first_file((name,))
        return run_files.read_ply(path) if path else None

    @functools.cached_property
    def times(self):
        """Columns of timing.csv [ms] by name, or None."""
        path = self._first_file(("timing.csv",))
        rows = run_files.read_csv(path, ("index", "odometry_ms")) if path else []
        if not rows:
            return None
        return {name: np.array([number(row[name]) for row in rows]) for name in rows[0]}

    @functools.cached_property
    def return_shares(self):
        """Share of the returns that were kept, and of those left out for each reason, by the names of
        scans.csv; None without these counts."""
        path = self._first_file(("scans.csv",))
        rows = run_files.read_csv(path, ("returns", "kept")) if path else []
        total = sum(int(row["returns"]) for row in rows)
        if not total:
            return None
        names = [name for name in RETURN_COLUMNS if name in rows[0]]
        return {name: sum(int(row[name]) for row in rows) / total for name in names}

    @functools.cached_property
    def facts(self):
        """run.json, empty where there is none."""
        path = self._first_file(("run.json",))
        return run_files.read_json(path) if path else {}


    @functools.cached_property
    def period_ms(self):
        """Median time between scans [ms], NaN where unknown."""
        if self.estimate is None or len(self.estimate) < 2:
            return math.nan
        return 1000 * float(np.median(np.diff(self.estimate[:, 0])))

    def scan_time(self, name):
        """The median or p95 of the time of a scan [ms], NaN where unknown."""
        if self.timing:
            return number(self.timing.get(f"ms_per_scan_{name}"))
        if not self.times:
            return math.nan
        return float(np.percentile(self.times["odometry_ms"], {"median": 50, "p95": 95}[name]))

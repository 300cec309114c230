# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a study: of radive_batch's output folder, or of results folders of radive_odometry."""

import dataclasses
import math
import pathlib

from report import run_files, trajectories
from report.run import TRAJECTORY_NAMES, Run
from report.run_files import FileError

METRICS = ("ate_t", "ate_r", "rpe_t", "rpe_r")
RESULT_COLUMNS = ("sequence", "variant", "seed", "status", "message", *METRICS)
SUMMARY_COLUMNS = ("variant", "sequence", "metric", "runs", "ok", "median", "q25", "q75")
RADIVE = "RaDiVe"  # the variant of runs that are of no study


@dataclasses.dataclass
class Study:
    title: str
    runs: list
    sequences: list
    variants: list  # names; the first is what the others are compared with
    labels: dict = dataclasses.field(default_factory=dict)  # of variants, where unlike the name
    summary: list = dataclasses.field(default_factory=list)  # rows of summary.csv
    published: list = dataclasses.field(default_factory=list)  # rows of published.csv
    is_single: bool = False
    align: str = "se3"
    plane: str = "xy"

    def label(self, variant):
        return self.labels.get(variant) or variant

    def of(self, sequence, variant=None):
        return [
            run
            for run in self.runs
            if run.sequence == sequence and (variant is None or run.variant == variant)
        ]

    def values(self, sequence, variant, value):
        """value(run) of the seeds that have one."""
        values = [value(run) for run in self.of(sequence, variant) if run.is_ok]
        return [value for value in values if not math.isnan(value)]

    def period_ms(self, sequence):
        """Time between scans [ms], None where unknown."""
        periods = (run.period_ms for run in self.of(sequence) if run.is_ok)
        return next((period for period in periods if period > 0), None)

    def typical_run(self, sequence, variant):
        """The run of the (lower) median ATE_t: the one to draw. None when all failed."""
        runs = [run for run in self.of(sequence, variant) if run.is_ok and run.estimate is not None]
        measured = [run for run in runs if not math.isnan(run.metric("ate_t"))]
        measured.sort(key=lambda run: run.metric("ate_t"))
        return measured[(len(measured) - 1) // 2] if measured else (runs[0] if runs else None)


def read_study(folders, reference=None, align="se3", plane="xy"):
    """The study of `folders`: one of radive_batch, or results folders, each as [NAME=]FOLDER.

    The other arguments are for results folders: ground truth of a single one, TUM, and what of
    the difference counts.
    """
    named = [split_name(str(folder)) for folder in folders]
    for _, folder in named:
        if not folder.is_dir():
            raise FileError(
                f"{folder}: no such folder, expected one of radive_batch or radive_odometry"
            )
    first = named[0][1]
    if (first / "results.csv").is_file():
        if reference or len(named) > 1:
            raise FileError(f"{first} is a study: it stands alone and has its own references")
        return read_batch(first)
    if reference and len(named) > 1:
        raise FileError("a reference is for one run; of several each has a reference.tum")
    names = [name for name, _ in named]
    if len(set(names)) < len(names):
        raise FileError("two runs have the same name; say NAME=FOLDER")
    runs = [read_run(name, folder, reference, align, plane) for name, folder in named]
    return Study(
        title=names[0] if len(runs) == 1 else "Runs",
        runs=runs,
        sequences=names,
        variants=[RADIVE],
        is_single=len(runs) == 1,
        align=align,
        plane=plane,
    )


def split_name(argument):
    """[NAME=]FOLDER; without a name the folder's own."""
    name, separator, folder = argument.partition("=")
    if separator and not pathlib.Path(argument).exists():
        return name, pathlib.Path(folder)
    return pathlib.Path(argument).resolve().name, pathlib.Path(argument)


def optional_csv(path, needed=()):
    return run_files.read_csv(path, needed) if path.is_file() else []


def key_of(row):
    return row["sequence"], row["variant"], row["seed"]


def read_batch(folder):
    """The layout is that of docs/studies.md."""
    rows = run_files.read_csv(folder / "results.csv", RESULT_COLUMNS)
    if not rows:
        raise FileError(f"{folder / 'results.csv'}: no runs")
    plan = run_files.read_json(folder / "study.json") if (folder / "study.json").is_file() else {}
    evaluate = plan.get("evaluate", {})
    align, plane = evaluate.get("align", "se3"), evaluate.get("plane", "xy")
    if align not in trajectories.ALIGNMENTS:
        align = "se3"  # of a scaled fit the figures show the rigid part
    timings = {key_of(row): row for row in optional_csv(folder / "timings.csv", RESULT_COLUMNS[:3])}
    runs = [
        batch_run(folder.joinpath("runs", *key_of(row)), row, timings, align, plane) for row in rows
    ]
    variants = plan.get("variants", [])
    return Study(
        title=plan.get("name") or folder.resolve().name,
        runs=runs,
        sequences=in_order(plan.get("sequences", []), (run.sequence for run in runs)),
        variants=in_order(variants, (run.variant for run in runs)),
        labels={variant["name"]: variant.get("label", "") for variant in variants},
        summary=optional_csv(folder / "summary.csv", SUMMARY_COLUMNS),
        published=optional_csv(folder / "published.csv", ("sequence", "method")),
        align=align,
        plane=plane,
    )


def batch_run(folder, row, timings, align, plane):
    truth = folder / "reference.tum"
    return Run(
        *key_of(row),
        status=row["status"],
        message=row["message"],
        folder=folder if folder.is_dir() else None,
        reference_file=truth if truth.is_file() else None,
        row=row,
        timing=timings.get(key_of(row), {}),
        align=align,
        plane=plane,
    )


def in_order(planned, found):
    """Names in the order of the plan, then those that are not in it."""
    found = list(dict.fromkeys(found))
    names = [entry["name"] for entry in planned if entry["name"] in found]
    return list(dict.fromkeys(names + found))


def read_run(name, folder, reference, align, plane):
    if not any((folder / trajectory).is_file() for trajectory in TRAJECTORY_NAMES):
        raise FileError(
            f"{folder}: neither results.csv (of radive_batch) nor trajectory_tum.txt (of "
            "radive_odometry) is in it"
        )
    truth = pathlib.Path(reference) if reference else folder / "reference.tum"
    if reference and not truth.is_file():
        raise FileError(f"{truth}: no such file, expected the true trajectory, TUM")
    run = Run(
        sequence=name,
        variant=RADIVE,
        seed="",
        folder=folder,
        reference_file=truth if truth.is_file() else None,
        align=align,
        plane=plane,
    )
    if run.reference_file:
        if run.errors is None:
            raise FileError(
                f"{truth}: fewer than 3 stamps are within {trajectories.MAX_TIME_DIFFERENCE} s of "
                f"those in {folder}"
            )
        ate_t, ate_r = run.errors.rmse()
        run.row.update(ate_t=str(ate_t), ate_r=str(math.degrees(ate_r)))
    run.row["path_length"] = str(trajectories.distance_travelled(run.estimate)[-1])
    run.row["scans"] = str(len(run.estimate))
    return run

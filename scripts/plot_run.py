#!/usr/bin/python3
"""Draws a run: trajectory over ground truth, errors over distance, and the map, as PNG files.

  scripts/plot_run.py --results RESULTS --output PLOTS [--reference GROUND_TRUTH_TUM]

RESULTS is the output folder of radive_odometry. Without a reference the errors are left out.
Needs python3-numpy and python3-matplotlib.
"""

import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # no display needed
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from report.figures import widen  # noqa: E402
from report.run_files import FileError, read_points, read_tum  # noqa: E402
from report.trajectories import PoseErrors, match  # noqa: E402


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    plt.close(figure)
    print(path)


def plot_trajectory(path, positions, reference):
    figure, axes = plt.subplots(figsize=(9, 6))
    if reference is not None:
        axes.plot(*reference[:, 1:3].T, color="0.6", linewidth=3, label="ground truth")
    axes.plot(*positions[:, :2].T, color="tab:blue", linewidth=1.2, label="RaDiVe")
    axes.plot(*positions[0, :2], "o", color="tab:blue", label="start")
    widen(axes)
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    axes.legend()
    axes.grid(alpha=0.3)
    save(figure, path)


def plot_errors(path, errors):
    figure, (upper, lower) = plt.subplots(2, sharex=True, figsize=(8, 5))
    upper.plot(errors.distance, errors.translation)
    upper.set(ylabel="position error [m]")
    lower.plot(errors.distance, np.degrees(errors.rotation), color="tab:orange")
    lower.set(xlabel="distance travelled [m]", ylabel="rotation error [deg]")
    for axes in (upper, lower):
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
    save(figure, path)


def plot_map(path, points, positions):
    figure, axes = plt.subplots(figsize=(10, 6))
    if len(points):
        low, high = np.percentile(points[:, 2], [5, 95])
        dots = axes.scatter(
            *points[:, :2].T, s=0.5, c=points[:, 2], cmap="viridis", vmin=low, vmax=max(high, low + 1)
        )
        figure.colorbar(dots, label="z [m]", shrink=0.7)
    axes.plot(*positions[:, :2].T, color="tab:red", linewidth=1)
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", type=pathlib.Path, required=True)
    parser.add_argument("--reference", type=pathlib.Path, help="ground truth, TUM")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="folder for the pictures")
    arguments = parser.parse_args()

    try:
        draw(arguments)
    except (FileError, ValueError) as error:
        sys.exit(f"plot_run.py: {error}")


def draw(arguments):
    estimate = read_tum(arguments.results / "trajectory_tum.txt")
    arguments.output.mkdir(parents=True, exist_ok=True)
    if arguments.reference:
        reference = read_tum(arguments.reference)
        # A fit of all positions would leave the roll open on straight drives.
        errors = PoseErrors(reference, estimate, align="origin", plane="none")
        plot_errors(arguments.output / "errors.png", errors)
        matched, _ = match(reference, estimate)
        plot_trajectory(arguments.output / "trajectory.png", errors.positions, matched)
    else:
        plot_trajectory(arguments.output / "trajectory.png", estimate[:, 1:4], None)
    map_file = arguments.results / "map.ply"
    if map_file.exists():
        plot_map(arguments.output / "map.png", read_points(map_file), estimate[:, 1:4])


if __name__ == "__main__":
    main()

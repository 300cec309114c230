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


def read_tum(path):
    """Rows of t x y z qx qy qz qw."""
    rows = np.loadtxt(path, comments="#", ndmin=2)
    if rows.size == 0 or rows.shape[1] != 8:
        sys.exit(f"{path}: expected lines of 8 numbers: t x y z qx qy qz qw")
    return rows


def read_ply(path):
    """Points (N x 3) of a binary little-endian PLY with float x y z."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    return np.frombuffer(data[end:], "<f4").reshape(-1, 3)


def rotation_matrices(quaternions):
    x, y, z, w = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    return np.stack(
        [
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], -1),
            np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], -1),
            np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], -1),
        ],
        -2,
    )


def match(reference, estimate, max_time_difference=0.01):
    """Rows of both whose stamps are nearest and close enough."""
    indices = np.searchsorted(reference[:, 0], estimate[:, 0]).clip(1, len(reference) - 1)
    before = np.abs(reference[indices - 1, 0] - estimate[:, 0])
    after = np.abs(reference[indices, 0] - estimate[:, 0])
    indices = np.where(before <= after, indices - 1, indices)
    close = np.minimum(before, after) <= max_time_difference
    return reference[indices[close]], estimate[close]


def align(reference, estimate):
    """Rotation and translation that lay the first estimated pose on the first reference pose.

    A fit of all positions would leave the roll open on straight drives.
    """
    rotation = rotation_matrices(reference[:1, 4:])[0] @ rotation_matrices(estimate[:1, 4:])[0].T
    return rotation, reference[0, 1:4] - rotation @ estimate[0, 1:4]


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    plt.close(figure)
    print(path)


def widen(axes):
    """A straight drive is no line without height: the shorter side gets a third of the longer one."""
    x, y = axes.get_xlim(), axes.get_ylim()
    least = max(x[1] - x[0], y[1] - y[0]) / 3
    for limits, set_limits in ((x, axes.set_xlim), (y, axes.set_ylim)):
        margin = (least - (limits[1] - limits[0])) / 2
        if margin > 0:
            set_limits(limits[0] - margin, limits[1] + margin)


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


def plot_errors(path, reference, estimate, rotation, positions):
    distance = np.concatenate(
        [[0.0], np.cumsum(np.linalg.norm(np.diff(reference[:, 1:4], axis=0), axis=1))]
    )
    position_error = np.linalg.norm(positions - reference[:, 1:4], axis=1)
    relative = np.swapaxes(rotation_matrices(reference[:, 4:]), 1, 2) @ (
        rotation @ rotation_matrices(estimate[:, 4:])
    )
    cosine = (np.trace(relative, axis1=1, axis2=2) - 1) / 2
    figure, (upper, lower) = plt.subplots(2, sharex=True, figsize=(8, 5))
    upper.plot(distance, position_error)
    upper.set(ylabel="position error [m]")
    lower.plot(distance, np.degrees(np.arccos(cosine.clip(-1, 1))), color="tab:orange")
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

    estimate = read_tum(arguments.results / "trajectory_tum.txt")
    arguments.output.mkdir(parents=True, exist_ok=True)
    reference = None
    positions = estimate[:, 1:4]
    if arguments.reference:
        reference, matched = match(read_tum(arguments.reference), estimate)
        if len(matched) < 3:
            sys.exit("fewer than 3 poses of estimate and reference have the same stamps")
        rotation, translation = align(reference, matched)
        aligned = matched[:, 1:4] @ rotation.T + translation
        plot_errors(arguments.output / "errors.png", reference, matched, rotation, aligned)
        plot_trajectory(arguments.output / "trajectory.png", aligned, reference)
    else:
        plot_trajectory(arguments.output / "trajectory.png", positions, None)
    map_file = arguments.results / "map.ply"
    if map_file.exists():
        plot_map(arguments.output / "map.png", read_ply(map_file), positions)


if __name__ == "__main__":
    main()

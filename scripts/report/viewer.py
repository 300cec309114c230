# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of the interactive 3D view: small, for the page carries it.

One scene a drawn run. All arrays are base64 of little-endian numbers:
  stamps    N float32      s since the first pose
  poses     N x 7 float32  x y z - origin [m], qx qy qz qw
  errors    N float32      position error after alignment [m]; NaN where unknown
  truth     M x 3 float32  ground truth in the frame of the estimate, - origin [m]
  points    P x 3 uint16   map, box_low + value / 65535 * box_size [m]
  shown     N uint32       how many of the points belong to the drive up to each pose
"""

import base64
import pathlib

import numpy as np

from report.figures import height_limits, thinned

FOLDER = pathlib.Path(__file__).resolve().parent / "viewer"
# Of a scene, and of all scenes of the page together: they stay below about 8 MB.
MOST_POSES, MOST_POSES_OF_ALL = 3000, 60000
MOST_POINTS, MOST_POINTS_OF_ALL = 60000, 400000
REVEAL_RANGE = 40.0  # a point shows once the radar is this near [m], or at its nearest


def encoded(array, form):
    return base64.b64encode(np.ascontiguousarray(array, form).tobytes()).decode("ascii")


def scenes(entries):
    """`entries` are (sequence, variant, run). Runs without a trajectory are left out."""
    entries = [entry for entry in entries if entry[2] is not None]
    count = max(1, len(entries))
    most_poses = min(MOST_POSES, MOST_POSES_OF_ALL // count)
    most_points = min(MOST_POINTS, MOST_POINTS_OF_ALL // count)
    return [scene(*entry, most_poses, most_points) for entry in entries]


def scene(sequence, variant, run, most_poses, most_points):
    poses = thinned(run.estimate, most_poses)
    origin = np.round(poses[0, 1:4], 3)
    errors = np.full(len(poses), np.nan)
    truth = np.empty((0, 3))
    if run.errors:
        rotation, translation = run.errors.transform
        errors = errors_at(poses[:, 0], run.errors)
        truth = (thinned(run.reference, most_poses)[:, 1:4] - translation) @ rotation - origin
    local = poses[:, 1:].copy()
    local[:, :3] -= origin
    points, shown = revealed(thinned(run.map_points, most_points) - origin, local[:, :3])
    low, size = np.zeros(3), np.ones(3)
    if len(points):
        low = points.min(0)
        size = np.maximum(points.max(0) - low, 1e-3)
    return {
        "sequence": sequence,
        "variant": variant,
        "seed": run.seed,
        "box_low": [round(float(v), 4) for v in low],
        "box_size": [round(float(v), 4) for v in size],
        "heights": [round(float(z), 3) for z in height_limits(points)] if len(points) else [0, 1],
        "view": view_limits(local[:, :3], points),
        "stamps": encoded(poses[:, 0] - poses[0, 0], "<f4"),
        "poses": encoded(local, "<f4"),
        "errors": encoded(errors, "<f4"),
        "truth": encoded(truth, "<f4"),
        "points": encoded(np.round((points - low) / size * 65535), "<u2"),
        "shown": encoded(shown, "<u4"),
    }


def errors_at(stamps, errors):
    """The error of the matched pose of the same stamp, NaN where the pose was not matched."""
    indices = np.searchsorted(errors.stamps, stamps).clip(0, len(errors.stamps) - 1)
    return np.where(errors.stamps[indices] == stamps, errors.translation[indices], np.nan)


def view_limits(positions, points):
    """The box to look at, low and high: the drive and the bulk of its map."""
    low, high = positions.min(0), positions.max(0)
    if len(points):
        bulk = np.percentile(points, [5, 95], axis=0)
        low, high = np.minimum(low, bulk[0]), np.maximum(high, bulk[1])
    return [[round(float(value), 2) for value in corner] for corner in (low, high)]


def revealed(points, positions):
    """The points in the order in which the drive comes near them, and their number by pose."""
    if not len(points):
        return points, np.zeros(len(positions), int)
    step = max(1, len(positions) // 600)
    coarse = positions[::step]
    first = np.empty(len(points), int)
    for start in range(0, len(points), 4096):
        chunk = points[start : start + 4096]
        squared = ((chunk[:, None, :2] - coarse[None, :, :2]) ** 2).sum(-1)
        near = np.maximum(squared.min(1, keepdims=True), REVEAL_RANGE**2)
        first[start : start + 4096] = np.argmax(squared <= near, axis=1) * step
    order = np.argsort(first, kind="stable")
    shown = np.searchsorted(first[order], np.arange(len(positions)), side="right")
    shown[-1] = len(points)
    return points[order], shown


def script():
    return (FOLDER / "dist" / "viewer.js").read_text(encoding="utf-8")


def licence():
    return (FOLDER / "LICENSE.three").read_text(encoding="utf-8")

# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses: association by time, alignment, absolute pose errors as evo and radive_evaluate have them.

A trajectory is N x 8: t x y z qx qy qz qw, as in a TUM file [s, m, -].
"""

import numpy as np

MAX_TIME_DIFFERENCE = 0.01  # [s], the default of evo and of radive_evaluate


def rotation_matrices(quaternions):
    """N x 4 (x y z w) to N x 3 x 3."""
    x, y, z, w = np.asarray(quaternions).T
    return np.stack(
        [
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], -1),
            np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], -1),
            np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], -1),
        ],
        -2,
    )


def match(reference, estimate, max_time_difference=MAX_TIME_DIFFERENCE):
    """Rows of both whose stamps are nearest and close enough."""
    if len(reference) == 1:
        indices = np.zeros(len(estimate), int)
    else:
        indices = np.searchsorted(reference[:, 0], estimate[:, 0]).clip(1, len(reference) - 1)
        before = np.abs(reference[indices - 1, 0] - estimate[:, 0])
        after = np.abs(reference[indices, 0] - estimate[:, 0])
        indices = np.where(before <= after, indices - 1, indices)
    close = np.abs(reference[indices, 0] - estimate[:, 0]) <= max_time_difference
    return reference[indices[close]], estimate[close]


def origin_alignment(reference, estimate):
    """Rotation and translation that lay the first estimated pose on the first reference pose."""
    rotation = rotation_matrices(reference[:1, 4:])[0] @ rotation_matrices(estimate[:1, 4:])[0].T
    return rotation, reference[0, 1:4] - rotation @ estimate[0, 1:4]


def se3_alignment(reference, estimate):
    """Rotation and translation of least squared distance between the positions (Umeyama 1991)."""
    to, start = reference[:, 1:4], estimate[:, 1:4]
    u, _, vt = np.linalg.svd((to - to.mean(0)).T @ (start - start.mean(0)))
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(u) * np.linalg.det(vt))])
    rotation = u @ flip @ vt
    return rotation, to.mean(0) - rotation @ start.mean(0)


def no_alignment(_reference, _estimate):
    return np.eye(3), np.zeros(3)


ALIGNMENTS = {"none": no_alignment, "origin": origin_alignment, "se3": se3_alignment}
PLANES = {"none": None, "xy": 2, "xz": 1, "yz": 0}  # the axis that is projected away


def planar(rotations, axis):
    """The part of each rotation (N x 3 x 3) about the axis, of yaw, pitch and roll."""
    if axis == 2:
        angle = np.arctan2(rotations[:, 1, 0], rotations[:, 0, 0])
    elif axis == 1:
        angle = -np.arctan2(
            -rotations[:, 2, 0], np.hypot(rotations[:, 0, 0], rotations[:, 1, 0])
        )
    else:
        angle = np.arctan2(rotations[:, 2, 1], rotations[:, 2, 2])
    first, second = [i for i in range(3) if i != axis]
    result = np.zeros_like(rotations)
    result[:, axis, axis] = 1
    result[:, first, first] = result[:, second, second] = np.cos(angle)
    result[:, second, first] = np.sin(angle)
    result[:, first, second] = -np.sin(angle)
    return result


def rotation_angles(rotations):
    """N x 3 x 3 to N angles [rad]. By the chord: the trace's arc cosine is blind below 1e-8."""
    chord = np.linalg.norm(rotations - np.eye(3), axis=(1, 2)) / np.sqrt(8)
    return 2 * np.arcsin(chord.clip(0, 1))


class PoseErrors:
    """Absolute pose errors of an estimate, as radive_evaluate has them.

    stamps [s], distance along the reference [m], translation [m], rotation [rad] (arrays of one
    value a matched pose); positions [m], the aligned ones; transform, the alignment.
    """

    def __init__(self, reference, estimate, align="se3", plane="xy"):
        reference, estimate = match(reference, estimate)
        if len(estimate) < 3:
            raise ValueError("fewer than 3 poses of estimate and reference have the same stamps")
        rotation, translation = self.transform = ALIGNMENTS[align](reference, estimate)
        self.stamps = estimate[:, 0]
        self.positions = estimate[:, 1:4] @ rotation.T + translation
        self.distance = distance_travelled(reference)
        difference = self.positions - reference[:, 1:4]
        true_rotations = rotation_matrices(reference[:, 4:])
        rotations = rotation @ rotation_matrices(estimate[:, 4:])
        axis = PLANES[plane]
        if axis is not None:
            difference[:, axis] = 0
            true_rotations, rotations = planar(true_rotations, axis), planar(rotations, axis)
        self.translation = np.linalg.norm(difference, axis=1)
        self.rotation = rotation_angles(np.swapaxes(true_rotations, 1, 2) @ rotations)

    def rmse(self):
        """ATE_t [m], ATE_r [rad]."""
        return np.sqrt(np.mean(self.translation**2)), np.sqrt(np.mean(self.rotation**2))


def distance_travelled(trajectory):
    """Length of the path up to each pose [m]."""
    steps = np.linalg.norm(np.diff(trajectory[:, 1:4], axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])

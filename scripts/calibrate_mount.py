#!/usr/bin/python3
"""Where the radar sits on a road vehicle, from registered motion alone: no ground truth.

usage: calibrate_mount.py TRAJECTORY_TUM [TRAJECTORY_TUM ...]

The rear axle moves where it points.  A radar that sits `lever` ahead of it sweeps sideways in a
turn, and sees straight travel under the angle `direction` (negative when its x axis points to the
left of travel):

    lateral = lever * turn + direction * forward

`lateral` and `forward` are the displacement over half a second, as seen half-way, `turn` the change
of yaw.  Both unknowns come from a robust fit (Cauchy, 0.05 m) to all given trajectories, which
should stem from runs without the no-slip prior:

    radive_odometry --input DRIVE --config CONFIG --set motion.no_slip=false --output DIR

Then sensor.mount_x = lever (for a radar that looks ahead), sensor.mount_yaw = -direction.

`rise` is the median elevation of straight travel in the radar frame (trajectories of
registration.planar=false only; 0 otherwise): sensor.mount_pitch = rise.
"""
import sys

import numpy as np

SPAN = 5  # scans
LOSS = 0.05  # [m]


def up_axes(quaternions):
    """The radar's z axis in the world frame, a row a pose."""
    x, y, z, w = quaternions.T
    return np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], 1)


def rows(path):
    """turn, forward, lateral, upward: a row for each span in which the radar moves."""
    t = np.loadtxt(path, comments="#", usecols=range(8))
    x, y, z, w = t[:, 4:].T
    yaw = np.unwrap(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    up = up_axes(t[:, 4:])
    d = t[SPAN:, 1:4] - t[:-SPAN, 1:4]
    middle = (yaw[SPAN:] + yaw[:-SPAN]) / 2
    forward = d[:, 0] * np.cos(middle) + d[:, 1] * np.sin(middle)
    lateral = d[:, 1] * np.cos(middle) - d[:, 0] * np.sin(middle)
    upward = (d * (up[SPAN:] + up[:-SPAN]) / 2).sum(1)
    moving = np.abs(forward) > 0.3
    return np.stack([yaw[SPAN:] - yaw[:-SPAN], forward, lateral, upward], 1)[moving]


def fit(samples):
    """Solution and standard deviations of (lever, direction)."""
    a, b = samples[:, :2], samples[:, 2]
    weight = np.ones(len(b))
    for _ in range(30):
        root = np.sqrt(weight)
        solution = np.linalg.lstsq(a * root[:, None], b * root, rcond=None)[0]
        weight = 1 / (1 + ((b - a @ solution) / LOSS) ** 2)
    scatter = np.linalg.inv((a * weight[:, None]).T @ a)
    residual = b - a @ solution
    # Overlapping spans share their noise: SPAN of them count as one sample.
    sigma = np.sqrt(np.diag(scatter) * SPAN * (weight * residual**2).sum() / weight.sum())
    return solution, sigma


def describe(name, samples):
    (lever, direction), sigma = fit(samples)
    rise = np.median(samples[:, 3] / samples[:, 1])
    print(
        f"{name}: lever {lever:.2f} +- {sigma[0]:.2f} m, "
        f"direction {direction:.4f} +- {sigma[1]:.4f} rad, rise {rise:.4f} rad"
    )


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    samples = [rows(path) for path in sys.argv[1:]]
    for path, part in zip(sys.argv[1:], samples):
        describe(path, part)
    describe("all", np.concatenate(samples))


if __name__ == "__main__":
    main()

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
"""
import sys

import numpy as np

SPAN = 5  # scans
LOSS = 0.05  # [m]


def rows(path):
    t = np.loadtxt(path, comments="#", usecols=range(8))
    x, y, z, w = t[:, 4:].T
    yaw = np.unwrap(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    d = t[SPAN:, 1:3] - t[:-SPAN, 1:3]
    middle = (yaw[SPAN:] + yaw[:-SPAN]) / 2
    forward = d[:, 0] * np.cos(middle) + d[:, 1] * np.sin(middle)
    lateral = d[:, 1] * np.cos(middle) - d[:, 0] * np.sin(middle)
    moving = np.abs(forward) > 0.3
    return np.stack([yaw[SPAN:] - yaw[:-SPAN], forward, lateral], 1)[moving]


def fit(samples):
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


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    samples = [rows(path) for path in sys.argv[1:]]
    for path, part in zip(sys.argv[1:], samples):
        (lever, direction), sigma = fit(part)
        print(f"{path}: lever {lever:.2f} +- {sigma[0]:.2f} m, direction {direction:.4f} +- {sigma[1]:.4f} rad")
    (lever, direction), sigma = fit(np.concatenate(samples))
    print(f"all: lever {lever:.2f} +- {sigma[0]:.2f} m, direction {direction:.4f} +- {sigma[1]:.4f} rad")


if __name__ == "__main__":
    main()

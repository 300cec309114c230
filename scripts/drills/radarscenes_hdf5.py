# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""RadarScenes' HDF5 files, of a simulated drive of raw scans. Needs Debian's python3-h5py."""

import math

import numpy

try:
    import h5py
except ImportError:
    h5py = None

DETECTION = [("timestamp", "<i8"), ("sensor_id", "u1"), ("range_sc", "<f4"), ("azimuth_sc", "<f4"),
             ("rcs", "<f4"), ("vr", "<f4"), ("vr_compensated", "<f4"), ("uuid", "S32"),
             ("track_id", "S32"), ("label_id", "u1")]
CAR_STATE = [("timestamp", "<i8"), ("x_seq", "<f4"), ("y_seq", "<f4"), ("yaw_seq", "<f4"),
             ("vx", "<f4"), ("yaw_rate", "<f4")]
START = 10**12  # [us]


def write(raw_drive, folder, compression=None):
    """The scans of the drive as those of radar 2, with a few of radar 3 between; its poses."""
    rows = []
    for k, stamp in enumerate((raw_drive / "times.txt").read_text().split()):
        time = START + int(stamp) // 1000
        scan = numpy.fromfile(raw_drive / "radar" / f"{k:06d}.bin", dtype="<f4").reshape(-1, 5)
        rows += [(time, 2, math.hypot(x, y), math.atan2(y, x), power, doppler, doppler, b"", b"", 0)
                 for x, y, _, doppler, power in scan]
        rows += [(time + 20000, 3, 10.0, 0.1, 1.0, 1.0, 1.0, b"", b"", 0)] * 5
    poses = [line.split() for line in (raw_drive / "gt_tum.txt").read_text().splitlines()]
    states = [(START + int(float(pose[0]) * 1e6), float(pose[1]), float(pose[2]),
               2.0 * math.atan2(float(pose[6]), float(pose[7])), 0.0, 0.0) for pose in poses]
    folder.mkdir(parents=True)
    with h5py.File(folder / "radar_data.h5", "w") as file:
        file.create_dataset("radar_data", data=numpy.array(rows, dtype=DETECTION),
                            compression=compression)
        file.create_dataset("odometry", data=numpy.array(states, dtype=CAR_STATE))

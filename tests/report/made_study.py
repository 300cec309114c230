# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small made-up results folders, with errors that are known by construction."""

import csv
import json
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))

HEADER = (
    "sequence,variant,seed,status,message,ate_t,ate_r,rpe_t,rpe_r,drift_t,drift_r,scans,registered,"
    "path_length,input_hash,config_hash,program_hash"
)
SUMMARY = (
    "variant,sequence,metric,runs,ok,median,q25,q75,min,max,pairs,difference,difference_low,"
    "difference_high,ratio,ratio_low,ratio_high,ratio_low_drives,ratio_high_drives"
)


def yaw_quaternion(yaw):
    yaw = np.asarray(yaw, float)
    return np.stack([0 * yaw, 0 * yaw, np.sin(yaw / 2), np.cos(yaw / 2)], -1)


def circle(count=60, radius=20.0, lift=0.0):
    """A trajectory once around a circle, at 10 Hz, heading along it: count x 8."""
    angle = np.linspace(0, 2 * np.pi, count)
    position = np.stack(
        [radius * np.sin(angle), radius * (1 - np.cos(angle)), np.full(count, lift)], -1
    )
    return np.column_stack([100 + 0.1 * np.arange(count), position, yaw_quaternion(angle)])


def write_tum(path, poses):
    path.write_text("".join(" ".join(f"{v:.9f}" for v in row) + "\n" for row in poses))


def write_ply(path, points, properties=("x", "y", "z")):
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    head += "".join(f"property float {name}\n" for name in properties) + "end_header\n"
    path.write_bytes(head.encode() + np.asarray(points, "<f4").tobytes())


def write_run(folder, estimate, reference=None, ms=5.0):
    folder.mkdir(parents=True)
    write_tum(folder / "trajectory_tum.txt", estimate)
    if reference is not None:
        write_tum(folder / "reference.tum", reference)
    rows = "".join(f"{i},0.1,{ms + 0.01 * (i % 7):.4f}\n" for i in range(len(estimate)))
    (folder / "timing.csv").write_text("index,read_ms,odometry_ms\n" + rows)
    random = np.random.default_rng(1)
    cloud = estimate[:, 1:4].repeat(20, axis=0) + random.normal(0, 5, (20 * len(estimate), 3))
    write_ply(folder / "map.ply", cloud)
    (folder / "run.json").write_text(json.dumps({"version": "0.1.0", "source": "made-up scans"}))


def write_surface(folder):
    """A wall along x = 5 m, with the files of output.map: mesh."""
    random = np.random.default_rng(2)
    points = np.zeros((500, 8))
    points[:, :3] = random.uniform([4, -10, -1], [6, 10, 1], (500, 3))
    points[:, 3] = -1
    points[:, 6] = 5 - points[:, 0]
    points[:, 7] = 3
    names = ("x", "y", "z", "nx", "ny", "nz", "sdf", "certainty")
    write_ply(folder / "neural_points.ply", points, names)
    write_ply(folder / "map.ply", points[np.abs(points[:, 6]) < 0.1], names)
    y, x = np.mgrid[-10:10.1:0.25, 4:6.1:0.25]
    grid = np.stack([x, y, 0 * x, 5 - x, 0 * x + 3], -1).reshape(-1, 5)
    write_ply(folder / "sdf_slice.ply", grid, ("x", "y", "z", "sdf", "certainty"))


def noisy(truth, sigma, seed):
    estimate = truth.copy()
    estimate[:, 1:4] += np.random.default_rng(seed).normal(0, sigma, (len(truth), 3))
    return estimate


def write_study(folder):
    """Two sequences, three variants, two seeds: the variant 'lost' crashes, 'far' is absent."""
    folder = pathlib.Path(folder)
    truth = circle()
    rows = []
    for variant, sigma in (("base", 0.2), ("ours", 0.1)):
        for seed in (0, 1):
            run = folder / "runs" / "loop" / variant / str(seed)
            write_run(run, noisy(truth, sigma, seed), truth)
            ate = (10 * sigma + seed, 100 * sigma)  # not that of the files: the table is read
            figures = [f"{v}" for v in (*ate, 0.5, 0.25, "", "", 60, 58, 125.6)]
            rows.append(["loop", variant, seed, "ok", "", *figures, "a", "b", "c"])
    for variant in ("base", "ours", "lost"):
        rows.append(["far", variant, 0, "absent", "no such folder", *[""] * 12])
    for seed in (0, 1):
        rows.append(["loop", "lost", seed, "crashed", "signal 11, a | b_c", *[""] * 12])
    rows.sort(key=lambda row: row[:3])
    write_csv(folder / "results.csv", HEADER, rows)
    better = "ours,*,ate_t,2,2,1.5,1.25,1.75,1,2,2,-1,-1.2,-0.8,0.55,0.5,0.66,0.4,1.2"
    worse = "ours,*,ate_r,2,2,10,9,11,8,12,2,1,0.5,2,1.5,1.1,1.9,,"
    write_csv(folder / "summary.csv", SUMMARY, [better.split(","), worse.split(",")])
    published = [["loop", "Paper", "1.2", "30"], ["far", "Paper", "-", "-"]]
    write_csv(folder / "published.csv", "sequence,method,ate_t,ate_r", published)
    plan = {
        "name": "made up",
        "sequences": [{"name": "loop"}, {"name": "far"}],
        "variants": [{"name": "base", "label": "The base"}, {"name": "ours"}, {"name": "lost"}],
        "evaluate": {"align": "se3", "plane": "none"},
    }
    (folder / "study.json").write_text(json.dumps(plan))
    return folder


def write_csv(path, header, rows):
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header.split(","))
        writer.writerows(rows)

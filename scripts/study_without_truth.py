#!/usr/bin/python3
"""How good is a drive without ground truth?  Registration without the Doppler prior against the
integrated Doppler velocity, the drive forward against backward, and the drift in height and pitch.

usage: study_without_truth.py --input FOLDER_OF_xyzdp5_SCANS --config CONFIG [--bin radive_odometry]

Backward: the same scans in reversed order with their Doppler negated, as if the vehicle had driven
back. Prints a Markdown table.
"""
import argparse
import csv
import glob
import os
import subprocess
import tempfile

import numpy as np


def rotation(q):
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def poses(folder):
    rows = np.loadtxt(folder + "/trajectory_tum.txt", comments="#")
    matrices = np.tile(np.eye(4), (len(rows), 1, 1))
    matrices[:, :3, 3] = rows[:, 1:4]
    matrices[:, :3, :3] = [rotation(q) for q in rows[:, 4:8]]
    return rows[:, 0], matrices


def run(args, source, settings):
    out = tempfile.mkdtemp()
    command = [args.bin, "--input", source, "--config", args.config, "--output", out, "--quiet"]
    subprocess.run(command + ["--set", settings], check=True)
    return out


def reversed_copy(source):
    folder = tempfile.mkdtemp()
    os.mkdir(folder + "/radar")
    files = sorted(glob.glob(source + "/radar/*.bin"))
    for index, path in enumerate(reversed(files)):
        points = np.fromfile(path, "<f4").reshape(-1, 5)
        points[:, 3] *= -1
        points.tofile(f"{folder}/radar/{index:06d}.bin")
    return folder


def integrated_doppler(out):
    """Length of the drive by the ego velocity, and the positions with the registered rotations."""
    stamps, matrices = poses(out)
    with open(out + "/scans.csv") as f:
        velocity = np.array([[float(row[k]) for k in ("vx", "vy", "vz")] for row in csv.DictReader(f)])
    dt = np.diff(stamps)
    mean = (velocity[1:] + velocity[:-1]) / 2
    step = np.einsum("nij,nj->ni", matrices[:-1, :3, :3], mean) * dt[:, None]
    return (np.linalg.norm(mean, axis=1) * dt).sum(), step.sum(0)


def angles(matrix):
    r = matrix[:3, :3]
    return np.degrees(np.arctan2(r[1, 0], r[0, 0])), np.degrees(-np.arcsin(r[2, 0]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--input", required=True)
    parser.add_argument("--config", required=True)
    parser.add_argument("--bin", default="build/apps/radive_odometry")
    args = parser.parse_args()
    back = reversed_copy(args.input)
    print("| run | path m | Doppler path m | end apart from Doppler m | height m | pitch deg | yaw deg |")
    print("|---|---|---|---|---|---|---|")
    ends = {}
    for name, source, settings in (("forward, no Doppler prior", args.input, "motion.doppler_prior=false"),
                                   ("backward, no Doppler prior", back, "motion.doppler_prior=false"),
                                   ("forward", args.input, "motion.doppler_prior=true"),
                                   ("backward", back, "motion.doppler_prior=true")):
        out = run(args, source, settings)
        _, matrices = poses(out)
        end = matrices[-1]
        ends[name] = end
        path = np.linalg.norm(np.diff(matrices[:, :3, 3], axis=0), axis=1).sum()
        doppler, position = integrated_doppler(out)
        apart = np.linalg.norm(position[:2] - end[:2, 3])
        yaw, pitch = angles(end)
        print(f"| {name} | {path:.2f} | {doppler:.2f} | {apart:.2f} | {end[2, 3]:.2f} | {pitch:.2f} | {yaw:.2f} |")
    for kind in ("", ", no Doppler prior"):
        closure = ends["forward" + kind] @ ends["backward" + kind]
        yaw, pitch = angles(closure)
        print(f"\nforward then backward{kind}: {np.linalg.norm(closure[:2, 3]):.2f} m apart in the plane, "
              f"{closure[2, 3]:.2f} m in height, {yaw:.2f} deg in yaw, {pitch:.2f} deg in pitch")


if __name__ == "__main__":
    main()

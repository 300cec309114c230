#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""What single bad scans do to real drives: every 50th scan of each radar is replaced by one from
elsewhere in the drive, by a copy rotated by 10 degrees, by 10 % of its returns, or left out.

usage: study_scan_faults.py [--bin build/apps/radive_odometry] [--shared ../shared] [--only PREFIX]
                            [--every N] [--set stage.field=value,...] [--jobs N]

Prints a Markdown table: the planar error of the trajectory (ATE [m], of drives without ground truth
against the trajectory of the undisturbed drive; rotation [deg]), and the ratio to the undisturbed
drive. Exit status 1 if a ratio of the translation is above 1.15 (and the error more than 2 cm
larger). Needs the real drives, which are not part of the project; without them it says so and ends.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys
import tempfile

import numpy as np

import real_drives

FAULTS = ("undisturbed", "elsewhere", "rotated", "thinned", "left out")
ANGLE = np.radians(10.0)


def rotated(scan, is_polar):
    scan = scan.copy()
    if is_polar:
        scan[:, 1] += ANGLE
    else:
        x, y = scan[:, 0].copy(), scan[:, 1].copy()
        scan[:, 0] = np.cos(ANGLE) * x - np.sin(ANGLE) * y
        scan[:, 1] = np.sin(ANGLE) * x + np.cos(ANGLE) * y
    return scan


def disturb(scans, fault, every, is_polar):
    random = np.random.default_rng(5)
    scans = list(scans)
    original = list(scans)
    for i in range(every - 1, len(scans), every):
        if fault == "elsewhere":
            scans[i] = original[(i + len(scans) // 2) % len(scans)]
        elif fault == "rotated":
            scans[i] = rotated(scans[i], is_polar)
        elif fault == "thinned":
            keep = random.permutation(len(scans[i]))[:max(1, len(scans[i]) // 10)]
            scans[i] = scans[i][np.sort(keep)]
        elif fault == "left out":
            scans[i] = None
    return scans


def run(args, name, source, config, settings, fault):
    """The file of the trajectory; raises RuntimeError when the program fails."""
    out = os.path.join(args.out, f"{name}_{fault.replace(' ', '_')}")
    with tempfile.TemporaryDirectory() as scratch:
        real_drives.copy(name, f"{args.shared}/data/{source}", scratch,
                         lambda scans: disturb(scans, fault, args.every, real_drives.is_polar(name)))
        command = [args.bin, "--input", scratch, "--config", f"configs/{config}", "--output", out, "--quiet"]
        words = [word for word in (settings, args.sets) if word]
        command += ["--set", ",".join(words)] if words else []
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"exit {done.returncode}: {done.stdout.strip()[-200:]}")
    return out + "/trajectory_tum.txt"


def study(args, ate, sequence):
    name = sequence[0]
    truth = f"{args.shared}/scoreboard/gt/{name}.txt"
    rows, failed, reference, healthy = [], False, None, None
    for fault in FAULTS:
        try:
            trajectory = run(args, *sequence, fault)
            if reference is None:
                reference = truth if os.path.exists(truth) else trajectory
            result = ate.evaluate(ate.load(reference), ate.load(trajectory))
        except (RuntimeError, ValueError, ate.BadTrajectory) as e:
            rows.append(f"| {name} | {fault} | {e} | | |")
            failed = True
            continue
        healthy = healthy or result
        ratios = [result[key] / healthy[key] if healthy[key] > 1e-6 else float("nan") for key in ("ate_t", "ate_r")]
        failed |= ratios[0] > 1.15 and result["ate_t"] > healthy["ate_t"] + 0.02
        rows.append(f"| {name} | {fault} | {result['ate_t']:.3f} / {result['ate_r']:.3f} | {ratios[0]:.2f} | {ratios[1]:.2f} |")
    return rows, failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", default="build/apps/radive_odometry")
    parser.add_argument("--shared", default="../shared")
    parser.add_argument("--only", default="")
    parser.add_argument("--every", type=int, default=50)
    parser.add_argument("--set", default="", dest="sets")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", default=os.path.join(tempfile.gettempdir(), "radive_scan_faults"))
    args = parser.parse_args()
    if not os.path.isdir(f"{args.shared}/scoreboard"):
        print(f"no real data at {args.shared}: nothing to study (see --shared)")
        return 0
    sys.path.insert(0, f"{args.shared}/scoreboard")
    sys.dont_write_bytecode = True
    import ate  # pylint: disable=import-error,import-outside-toplevel

    os.makedirs(args.out, exist_ok=True)
    chosen = [s for s in real_drives.sequences(f"{args.shared}/data") if s[0].startswith(args.only)]
    print("| sequence | every %d. scan | ATE (m / deg) | ratio t | ratio r |\n| --- | --- | --- | --- | --- |" % args.every)
    failed = False
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for rows, has_failed in pool.map(lambda s: study(args, ate, s), chosen):
            print("\n".join(rows), flush=True)
            failed |= has_failed
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Doppler that makes no sense does to real drives: each sequence as it is, with the sign left
open, and with its Doppler turned, in km/h, in cm/s, zero, compensated for the motion of the radar,
and dealt out anew among the returns of each scan.

usage: study_doppler_faults.py [--bin build/apps/radive_odometry] [--shared ../shared] [--only PREFIX] [--scans N] [--jobs N]

Prints a Markdown table: the error of the trajectory (ATE; of drives without ground truth, against
the trajectory of the drive as it is), and what run.json says. A fault is "right" where the error
is within 10 % (and 2 cm) of that of the drive as it is, "told" where a warning names the Doppler,
and SILENT otherwise. Without a fault a warning is a FALSE ALARM, unless it only says that the
points do not tell (undecided). Exit status 1 if anything is silent or a false alarm. Needs the
real data, which are not part of the project; without them it says so and ends.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

import real_drives

FAULTS = ("as it is", "sign open", "turned", "turned, sign open", "km/h", "cm/s", "zero", "compensated", "shuffled")


def static_doppler(directions, doppler):
    """The range rates of static returns by a robust fit of one velocity."""
    keep = np.ones(len(doppler), bool)
    velocity = np.zeros(directions.shape[1])
    for gate in (8.0, 4.0, 2.0, 1.0, 0.5, 0.3, 0.3):
        if keep.sum() < 5:
            break
        velocity = np.linalg.lstsq(-directions[keep], doppler[keep], rcond=None)[0]
        keep = np.abs(doppler + directions @ velocity) < gate
    return -directions @ velocity


def faulty(doppler, directions, fault, random):
    if fault.startswith("turned"):
        return -doppler
    if fault == "km/h":
        return 3.6 * doppler
    if fault == "cm/s":
        return 100.0 * doppler
    if fault == "zero":
        return 0.0 * doppler
    if fault == "compensated":
        return doppler - static_doppler(directions, doppler)
    if fault == "shuffled":
        return random.permutation(doppler)
    return doppler


def disturb(scans, fault, is_polar, random):
    column = 2 if is_polar else 3
    for scan in scans:
        if is_polar:
            directions = np.stack([np.cos(scan[:, 1]), np.sin(scan[:, 1])], 1)
        else:
            directions = scan[:, :3] / np.maximum(np.linalg.norm(scan[:, :3], axis=1, keepdims=True), 1e-6)
        scan[:, column] = faulty(scan[:, column].copy(), directions, fault, random)
    return scans


def run(args, name, source, config, settings, fault):
    """Trajectory file, warnings, CPU time per scan [ms], notes."""
    out = os.path.join(args.out, f"{name}_{fault.replace(' ', '_').replace('/', '').replace(',', '')}")
    with tempfile.TemporaryDirectory() as scratch:
        random = np.random.default_rng(11)
        real_drives.copy(name, f"{args.shared}/data/{source}", scratch,
                         lambda scans: disturb(scans, fault, real_drives.is_polar(name), random))
        words = [settings] if settings else []
        if "sign open" in fault:
            words.append("input.doppler_sign=auto")
        command = [args.bin, "--input", scratch, "--config", f"configs/{config}", "--output", out, "--quiet"]
        command += ["--set", ",".join(words)] if words else []
        command += ["--frames", str(args.scans)] if args.scans else []
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    with open(out + "/run.json") as f:
        report = json.load(f)
    if done.returncode:
        report["warnings"].append(f"exit {done.returncode}: {done.stdout.strip()[-200:]}")
    return out + "/trajectory_tum.txt", report["warnings"], report["notes"]


def doppler_warnings(warnings):
    return [w for w in warnings if "Doppler" in w or w.startswith("exit")]


def study(args, ate, sequence):
    name, source, config, settings = sequence
    truth = f"{args.shared}/scoreboard/gt/{name}.txt"
    rows, healthy, failed = [], None, False
    for fault in FAULTS:
        trajectory, warnings, notes = run(args, name, source, config, settings, fault)
        told, why = doppler_warnings(warnings), []
        if fault == "as it is":
            as_it_is = trajectory
        try:
            reference = truth if os.path.exists(truth) else as_it_is
            result = ate.evaluate(ate.load(reference), ate.load(trajectory))
            error = result["ate_t"]
        except (ate.BadTrajectory, ValueError) as e:
            error, why = float("inf"), [f"no error: {e}"]
        healthy = error if healthy is None else healthy
        right = error <= 1.1 * healthy + 0.02
        is_healthy = fault in ("as it is", "sign open")
        if is_healthy:
            open_only = all("undecided" in w or "do not tell" in w for w in told)
            verdict = "FALSE ALARM" if not (right and open_only) else "undecided" if told else "right"
        else:
            verdict = "right" if right and not told else "right, told" if right else "told" if told else "SILENT"
        failed |= verdict in ("FALSE ALARM", "SILENT")
        said = "; ".join(told or [n for n in notes if "Doppler" in n] + (why if error == float("inf") else []))
        rows.append(f"| {name} | {fault} | {error:.3f} | {verdict} | {said} |")
    return rows, failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", default="build/apps/radive_odometry")
    parser.add_argument("--shared", default="../shared")
    parser.add_argument("--only", default="")
    parser.add_argument("--scans", type=int, default=0, help="of each drive; 0: all")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", default=os.path.join(tempfile.gettempdir(), "radive_doppler_faults"))
    args = parser.parse_args()
    if not os.path.isdir(f"{args.shared}/scoreboard"):
        print(f"no real data at {args.shared}: nothing to study (see --shared)")
        return 0
    sys.path.insert(0, f"{args.shared}/scoreboard")
    sys.dont_write_bytecode = True
    import ate  # pylint: disable=import-error,import-outside-toplevel

    os.makedirs(args.out, exist_ok=True)
    chosen = [s for s in real_drives.sequences(f"{args.shared}/data")
              if s[0].startswith(args.only) and not s[0].startswith("vod")]  # which has no Doppler
    print("| sequence | fault | ATE (m) | verdict | what run.json says |\n| --- | --- | --- | --- | --- |")
    failed = False
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for rows, has_failed in pool.map(lambda s: study(args, ate, s), chosen):
            print("\n".join(rows), flush=True)
            failed |= has_failed
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

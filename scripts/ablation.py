#!/usr/bin/python3
"""Does surface extraction make odometry better?  The paper's ablation, V.Unc. x S.P.E., with intervals.

  scripts/ablation.py vod                      the View-of-Delft five (no Doppler: S.P.E. alone)
  scripts/ablation.py radarscenes              105_2 and 105_3
  scripts/ablation.py dense sparse             simulated streets, seeds 0 to 4
  scripts/ablation.py vod --only_rows --row 'soft=submap.type=sdf,surface.soft=true'

Registration is chaotic, so every drive is run --runs times: each time 2 % of the returns are dropped
and the start is shifted by 0 to 7 scans, seeded, the same for all rows. Rows are then compared run by
run with the first row: the median ratio of the errors over all drives and runs, with a 95 % interval
from bootstrap within drives. A run that is lost counts with its error, however large.

Real drives are read from --data and their true poses from --truth (see README). Prints a Markdown table.
"""
import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPE = "submap.type=sdf"
UNC = "ego_velocity.weights=true"
NO_UNC = "ego_velocity.weights=false"
ROWS = {
    "V.Unc. off, S.P.E. off": NO_UNC,
    "V.Unc. off, S.P.E. on": f"{NO_UNC},{SPE}",
    "V.Unc. on, S.P.E. off": UNC,
    "V.Unc. on, S.P.E. on": f"{UNC},{SPE}",
    "V.Unc. on, as many points by density": f"{UNC},{SPE},surface.criterion=density",
}
ROWS_WITHOUT_DOPPLER = {
    "S.P.E. off": "",
    "S.P.E. on": SPE,
    "as many points by density": f"{SPE},surface.criterion=density",
}
SIMULATED = ("input.format=raw,input.layout=xyzdp5,sensor.mount_x=3.7,sensor.mount_z=0.6,"
             "registration.planar=true,motion.no_slip=true,motion.slip_compliance=0")


def run(command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False)
    if result.returncode:
        sys.exit(f"ablation.py: {' '.join(map(str, command))}:\n{result.stdout}")
    return result.stdout


class Drive:
    """A sequence: where it lies, its configuration and settings, and its true trajectory."""

    def __init__(self, name, folder, config, truth, sets=""):
        self.name, self.folder, self.config, self.truth, self.sets = name, folder, config, truth, sets

    def thinned(self, target, random):
        """A copy with 2 % of the returns left out."""
        shutil.copytree(self.folder, target, ignore=shutil.ignore_patterns("labels", "gt_*"))
        if self.config == "radarscenes.yaml":
            radar = self.sets.split("input.radar=")[1]
            thin_radarscenes(target, radar, random)
            return
        floats = {"vod_xyz.yaml": 3}.get(self.config, 5)
        for path in sorted(target.glob("radar/*.bin")):
            points = np.fromfile(path, "<f4").reshape(-1, floats)
            points[random.random(len(points)) >= 0.02].tofile(path)


def thin_radarscenes(folder, radar, random):
    points_path, scans_path = folder / f"radar{radar}_points.bin", folder / f"radar{radar}_scans.csv"
    points = np.fromfile(points_path, "<f4").reshape(-1, 5)
    keep = random.random(len(points)) >= 0.02
    before = np.concatenate(([0], np.cumsum(keep)))
    with open(scans_path, newline="") as file:
        header, *rows = list(csv.reader(file))
    first, count = header.index("first_point"), header.index("num_points")
    for row in rows:
        begin = int(row[first])
        end = begin + int(row[count])
        row[first], row[count] = str(before[begin]), str(before[end] - before[begin])
    points[keep].tofile(points_path)
    with open(scans_path, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header] + rows)


def drives(group, args, scratch):
    if group == "vod":
        return [Drive(f"vod_{k}", args.data / f"vod-radar-xyz/delft_{k}", "vod_xyz.yaml",
                      args.truth / f"vod_{k}.txt") for k in ("04", "06", "12", "24", "26")]
    if group == "radarscenes":
        return [Drive(f"radarscenes_105_{k}", args.data / "radarscenes/seq105", "radarscenes.yaml",
                      args.truth / f"radarscenes_105_{k}.txt", f"input.radar={k}") for k in (2, 3)]
    result = []
    for seed in range(5):
        folder = scratch / f"{group}_{seed}"
        run([args.bin / "radive_simulate", f"--scenario=street_{group}", f"--seed={seed}",
             f"--frames={args.frames}", f"--output={folder}"])
        dense = "ndt.representation=voxel,submap.num_keyframes=15,input.rate=12"
        sparse = ("input.rate=20,sensor.sigma_range=0.12,sensor.sigma_azimuth=0.0052,"
                  "sensor.sigma_elevation=0.014")
        result.append(Drive(f"street_{group}_{seed}", folder, "", folder / "gt_tum.txt",
                            f"{SIMULATED},{dense if group == 'dense' else sparse}"))
    return result


def errors(args, truth, out):
    values = []
    for relation in ("trans_part", "angle_deg"):
        text = run([args.bin / "radive_evaluate", f"--reference={truth}",
                    f"--estimate={out}/trajectory_tum.txt", "--align=se3", "--plane=xy",
                    f"--relation={relation}", "--json"])
        values.append(json.loads(text)["rmse"])
    return values


def run_once(args, drive, folder, start, sets):
    """ATE_t [m] and ATE_r [deg] in the plane, and CPU milliseconds a scan."""
    with tempfile.TemporaryDirectory() as out:
        command = [args.bin / "radive_odometry", f"--input={folder}", f"--output={out}/run",
                   f"--start={start}", "--quiet", "--set",
                   ",".join(s for s in (drive.sets, "output.map=none", args.set, sets) if s)]
        if drive.config:
            command.append(f"--config={ROOT / 'configs' / drive.config}")
        run(command)
        with open(f"{out}/run/run.json") as file:
            milliseconds = json.load(file)["mean_ms_per_frame"]
        return [*errors(args, drive.truth, f"{out}/run"), milliseconds]


def measure(args, group, rows, scratch):
    """Array of errors: row x drive x run x (ATE_t, ATE_r, ms)."""
    chosen = drives(group, args, scratch)
    jobs = {}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for d, drive in enumerate(chosen):
            for r in range(args.runs):
                random = np.random.default_rng([d, r])
                folder = scratch / f"{drive.name}_run{r}"
                drive.thinned(folder, random)
                start = int(random.integers(8))
                for i, sets in enumerate(rows.values()):
                    jobs[i, d, r] = pool.submit(run_once, args, drive, folder, start, sets)
        values = np.zeros((len(rows), len(chosen), args.runs, 3))
        for key, job in jobs.items():
            values[key] = job.result()
    return [drive.name for drive in chosen], values


def interval(log_ratios):
    """Median ratio and its 95 % interval; `log_ratios`: drive x run."""
    random = np.random.default_rng(1)
    num_drives, num_runs = log_ratios.shape
    medians = []
    for _ in range(2000):
        picks = random.integers(num_runs, size=(num_drives, num_runs))
        medians.append(np.median(np.take_along_axis(log_ratios, picks, axis=1)))
    low, high = np.exp(np.percentile(medians, [2.5, 97.5]))
    return f"{np.exp(np.median(log_ratios)):.3f} ({low:.3f} .. {high:.3f})"


def report(names, rows, values):
    print("| row | " + " | ".join(names) + " | ATE_t, ratio to the first row | ATE_r, ratio | ms a scan |")
    print("|---" * (len(names) + 4) + "|")
    for i, row in enumerate(rows):
        cells = [f"{np.median(values[i, d, :, 0]):.3f} / {np.median(values[i, d, :, 1]):.2f}"
                 for d in range(len(names))]
        ratios = ["1", "1"] if i == 0 else [
            interval(np.log(values[i, :, :, k] / values[0, :, :, k])) for k in (0, 1)]
        print(f"| {row} | " + " | ".join(cells + ratios) + f" | {values[i, :, :, 2].mean():.1f} |",
              flush=True)
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("groups", nargs="+", choices=["vod", "radarscenes", "dense", "sparse"])
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/apps")
    parser.add_argument("--data", type=pathlib.Path, default=ROOT / "../shared/data")
    parser.add_argument("--truth", type=pathlib.Path, default=ROOT / "../shared/scoreboard/gt")
    parser.add_argument("--runs", type=int, default=8, help="perturbed runs a drive")
    parser.add_argument("--frames", type=int, default=600, help="scans of a simulated drive")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time")
    parser.add_argument("--set", default="", help="settings for all rows")
    parser.add_argument("--row", action="append", default=[], help="one more row: NAME=SETTINGS")
    parser.add_argument("--only_rows", action="store_true", help="the first row and those of --row alone")
    args = parser.parse_args()
    for group in args.groups:
        rows = dict(ROWS_WITHOUT_DOPPLER if group == "vod" else ROWS)
        if args.only_rows:
            first = "S.P.E. off" if group == "vod" else "V.Unc. on, S.P.E. off"
            rows = {first: rows[first]}
        rows.update(row.split("=", 1) for row in args.row)
        with tempfile.TemporaryDirectory() as scratch:
            names, values = measure(args, group, rows, pathlib.Path(scratch))
        print(f"{group}: medians of {args.runs} runs, ATE_t m / ATE_r deg\n")
        report(names, rows, values)


if __name__ == "__main__":
    main()

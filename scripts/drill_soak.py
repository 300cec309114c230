#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory and time of long drives: neither may grow with the number of scans.

  scripts/drill_soak.py [--programs=build/apps] [--scans=20000] [--seconds=1800]
                        [--threads=1] [CASE ...]

Cases are sparse_raw, sparse_sdf, dense_raw and dense_sdf; all of them if none is named. Dense scans
are as large as the radar gives them, and the neural submap stands in for the raw one to the end.
Memory is the resident set, time the processor's, so that a busy machine does not matter. Compared
are the second tenth of the scans and the last: the medians of the memory, the times per scan. Bad is
a case that has grown by more than 10 % and 3 MB, or by more than 25 % and 1 ms. A case that takes
longer than --seconds is interrupted, and judged by the scans that it got to.
"""

import argparse
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time

SDF = ["submap.type=sdf", "sdf_submap.bypass_neighbors=0"]
# Scenario, and settings.
CASES = {
    "sparse_raw": ("street_sparse", []),
    "sparse_sdf": ("street_sparse", SDF),
    "dense_raw": ("street_dense", []),
    "dense_sdf": ("street_dense", SDF),
}
BYPASSED = "surface extraction is bypassed"  # a warning of run.json


def resident_mb(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return None


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def watch(process, output, seconds):
    """[(bytes of the trajectory so far, MB, CPU seconds)] until the program ends."""
    begin = time.monotonic()
    partial = output / ".trajectory_tum.txt.partial"
    samples = []
    is_stopped = False
    while process.poll() is None:
        try:
            megabytes = resident_mb(process.pid)
            if megabytes is not None and partial.exists():
                samples.append((partial.stat().st_size, megabytes, cpu_seconds(process.pid)))
        except OSError:
            pass  # it has ended meanwhile
        if time.monotonic() - begin > seconds and not is_stopped:
            process.send_signal(signal.SIGINT)
            is_stopped = True
        time.sleep(0.05)
    return samples


def run(options, name, folder):
    """Number of scans, and the samples of watch()."""
    scenario, settings = CASES[name]
    drive, output = folder / f"{scenario}_{options.scans}", folder / "results"
    if not drive.exists():
        subprocess.run([options.programs / "radive_simulate", f"--scenario={scenario}",
                        f"--frames={options.scans}", f"--output={drive}"],
                       check=True, stdout=subprocess.DEVNULL)
    settings = ",".join(["input.layout=xyzdp5", "output.map=none", *settings])
    process = subprocess.Popen([options.programs / "radive_odometry", f"--input={drive}", "--quiet",
                                f"--output={output}", f"--set={settings}",
                                f"--threads={options.threads}"],
                               stderr=subprocess.DEVNULL)
    samples = watch(process, output, options.seconds)
    if process.returncode not in (0, 130):
        sys.exit(f"drill_soak.py: {name}: exit status {process.returncode}")
    if BYPASSED in (output / "run.json").read_text(encoding="utf-8"):
        sys.exit(f"drill_soak.py: {name}: {BYPASSED}")
    return len((output / "trajectory_tum.txt").read_text(encoding="utf-8").splitlines()), samples


def tenths(num_scans, samples):
    """Of each tenth of the scans the median MB and the CPU milliseconds per scan."""
    found = []
    size = samples[-1][0]
    for k in range(10):
        part = [s for s in samples if size * k <= 10 * s[0] <= size * (k + 1)]
        if len(part) < 2:
            sys.exit("drill_soak.py: too short, too few samples")
        scans = (part[-1][0] - part[0][0]) / size * num_scans
        if scans == 0:
            sys.exit("drill_soak.py: too short, too few scans")
        found.append((statistics.median(megabytes for _, megabytes, _ in part),
                      1000 * (part[-1][2] - part[0][2]) / scans))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=pathlib.Path("build/apps"))
    parser.add_argument("--scans", type=int, default=20000)
    parser.add_argument("--seconds", type=float, default=1800)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    options = parser.parse_args()
    bad = 0
    with tempfile.TemporaryDirectory(prefix="radive_soak_") as folder:
        for name in options.cases or CASES:
            num_scans, samples = run(options, name, pathlib.Path(folder))
            found = tenths(num_scans, samples)
            (m0, t0), (m1, t1) = found[1], found[9]
            grows = (m1 > 1.1 * m0 and m1 > m0 + 3) or (t1 > 1.25 * t0 and t1 > t0 + 1)
            bad += grows
            print(f"{name}: {num_scans} scans; MB in each tenth "
                  + " ".join(f"{megabytes:.1f}" for megabytes, _ in found)
                  + "; CPU ms per scan " + " ".join(f"{ms:.2f}" for _, ms in found)
                  + ("; grows" if grows else ""), flush=True)
    print(f"TOTAL bad {bad}")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()

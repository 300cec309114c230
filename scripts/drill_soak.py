#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory and time of long drives: neither may grow with the number of scans.

  scripts/drill_soak.py [--programs=build/apps] [--scans=20000] [--seconds=1800] [CASE ...]

Cases are sparse_raw, sparse_sdf, dense_raw and dense_sdf; all of them if none is named. Memory is
the resident set while the scan is worked on; time is that of the odometry in timing.csv, without
reading. Compared are the medians of the second tenth of the scans and of the last. Bad is a case
that has grown by more than 10 % and 3 MB, or by more than 25 % and 1 ms. A case that takes longer
than --seconds is interrupted, and judged by the scans that it got to.
"""

import argparse
import csv
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time

# Scenario, returns per scan (0: as the radar), and settings.
CASES = {
    "sparse_raw": ("street_sparse", 0, []),
    "sparse_sdf": ("street_sparse", 0, ["submap.type=sdf"]),
    "dense_raw": ("street_dense", 400, []),
    "dense_sdf": ("street_dense", 400, ["submap.type=sdf"]),
}


def resident_mb(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return None


def run(options, name, folder):
    """[(seconds, MB)], [ms] of the odometry of each scan."""
    scenario, returns, settings = CASES[name]
    drive, output = folder / f"{scenario}_{options.scans}", folder / "results"
    if not drive.exists():
        subprocess.run([options.programs / "radive_simulate", f"--scenario={scenario}",
                        f"--frames={options.scans}", f"--output={drive}",
                        f"--set=simulation.returns={returns}"],
                       check=True, stdout=subprocess.DEVNULL)
    settings = ",".join(["input.layout=xyzdp5", "output.map=none", *settings])
    begin = time.monotonic()
    process = subprocess.Popen([options.programs / "radive_odometry", f"--input={drive}", "--quiet",
                                f"--output={output}", f"--set={settings}"],
                               stderr=subprocess.DEVNULL)
    samples = []
    while process.poll() is None:
        now = time.monotonic() - begin
        megabytes = resident_mb(process.pid)
        if megabytes is not None:
            samples.append((now, megabytes))
        if now > options.seconds and process.returncode is None:
            process.send_signal(signal.SIGINT)
            process.wait()
        time.sleep(0.05)
    if process.returncode not in (0, 130):
        sys.exit(f"drill_soak.py: {name}: exit status {process.returncode}")
    with open(output / "timing.csv", encoding="utf-8") as stream:
        times = [float(row["odometry_ms"]) for row in csv.DictReader(stream)]
    return samples, times


def tenth(values, number):
    size = len(values) // 10
    return statistics.median(values[number * size:(number + 1) * size])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=pathlib.Path("build/apps"))
    parser.add_argument("--scans", type=int, default=20000)
    parser.add_argument("--seconds", type=float, default=1800)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    options = parser.parse_args()
    bad = 0
    with tempfile.TemporaryDirectory(prefix="radive_soak_") as folder:
        for name in options.cases or CASES:
            samples, times = run(options, name, pathlib.Path(folder))
            memory = [megabytes for _, megabytes in samples]
            if len(times) < 100 or len(memory) < 20:
                sys.exit(f"drill_soak.py: {name}: too short, {len(times)} scans")
            m0, m1, t0, t1 = (tenth(v, n) for v in (memory, times) for n in (1, 9))
            grows = (m1 > 1.1 * m0 and m1 > m0 + 3) or (t1 > 1.25 * t0 and t1 > t0 + 1)
            bad += grows
            print(f"{name}: {len(times)} scans; {m0:.1f} MB in the second tenth, half-way "
                  f"{tenth(memory, 5):.1f}, {m1:.1f} in the last, at most {max(memory):.1f}; "
                  f"{t0:.2f} ms per scan, then {t1:.2f}{'; grows' if grows else ''}", flush=True)
    print(f"TOTAL bad {bad}")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lets the disk fail while an input is read: that is an error, no damage of the file.

  read_errors.py [FRAMES] [FORM ...]

In every form of radive_simulate strace lets the reads of one file fail with EIO, one of them or all
from one on. radive_odometry must then end with 1 and name the file, or give the poses of the whole
drive, where the bytes were not needed or read once more.
"""

import pathlib
import re
import shutil
import subprocess
import sys

import common

READS = "read,pread64,readv,preadv"
MOST_READS = 40  # of a file, looked at one by one
NOT_READ = ("labels", "scenario.json", "gt_tum.txt")  # by radive_odometry


def forms():
    text = common.run([common.PROGRAMS / "radive_simulate", "--help"]).stdout
    text = re.sub(r"\([^)]*\)", "", re.sub(r"\s+", " ", text))
    return [form.strip() for form in re.search(r"Form of the scans: ([^.]*)\.", text)[1].split("|")]


def inputs(drive):
    """Tables, and the first, the middle and the last of the scans."""
    files = sorted(path for path in drive.rglob("*") if path.is_file()
                   and path.relative_to(drive).parts[0] not in NOT_READ)
    scans = [path for path in files if re.search(r"\d{3,}\.\w+$", path.name)]
    some = scans[:1] + scans[len(scans) // 2:len(scans) // 2 + 1] + scans[-1:]
    return [path for path in files if path not in scans] + some


def run(command, strace, log, file, when):
    """What radive_odometry says, and whether a read has failed."""
    done = common.run([strace, "-f", "-qq", "-o", log, "-P", file, "-e", f"trace={READS}",
                       "-e", f"inject={READS}:error=EIO:when={when}", *command])
    return done, "(INJECTED)" in log.read_text(encoding="utf-8", errors="replace")


def drill(form, work, strace, frames):
    """Number of failing reads, and those that were taken wrongly."""
    drive, output = work / form, work / "results"
    common.run([common.PROGRAMS / "radive_simulate", "--scenario=street_sparse", f"--frames={frames}",
                "--set=simulation.rate=5,simulation.returns=60", f"--format={form}",
                f"--output={drive}"], check=True)
    layout = ["--set=input.layout=xyzdp5"] if form == "raw" else []
    command = [common.PROGRAMS / "radive_odometry", f"--input={drive}", f"--output={output}",
               "--quiet", *layout]
    common.run(command, check=True)
    poses = (output / "trajectory_tum.txt").read_bytes()
    tried, bad = 0, []
    for file in inputs(drive):
        for number in range(1, MOST_READS + 1):
            is_over = True
            for when in (f"{number}", f"{number}+"):
                shutil.rmtree(output, ignore_errors=True)
                done, has_failed = run(command, strace, work / "strace.log", file, when)
                if not has_failed:
                    continue
                is_over = False
                tried += 1
                is_error = done.returncode == 1 and str(file) in done.stderr
                is_whole = (done.returncode == 0
                            and (output / "trajectory_tum.txt").read_bytes() == poses)
                if not is_error and not is_whole:
                    bad.append(f"{file.relative_to(work)}, read {when}: status {done.returncode}, "
                               f"{done.stderr.strip()[-150:]!r}")
            if is_over:
                break
    return tried, bad


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    strace = shutil.which("strace")
    if not strace or subprocess.run([strace, "-o", "/dev/null", "true"], check=False).returncode:
        print("TOTAL read_errors: skipped, strace cannot be used here")
        return 77
    worst = 0
    with common.scratch() as folder:
        for form in sys.argv[2:] or forms():
            tried, bad = drill(form, pathlib.Path(folder).resolve(), strace, frames)
            worst += len(bad)
            print(f"{form}: {tried} failing reads, {len(bad)} taken wrongly", flush=True)
            for entry in bad[:5]:
                print("  ", entry, flush=True)
    print(f"TOTAL read_errors: bad {worst}")
    return 1 if worst else 0


sys.exit(main())

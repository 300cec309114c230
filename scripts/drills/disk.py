#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fills the disk: earlier results stay whole, the message names a file, afterwards it works again.

  disk.py [FRAMES] [SIZES] [PROGRAM ...]

50 sizes of free room on a tmpfs of its own; needs root.
"""

import os
import pathlib
import subprocess
import sys

import common

def fill(folder, leave):
    status = os.statvfs(folder)
    filler = folder / "filler"
    filler.write_bytes(bytes(max(0, status.f_bavail * status.f_frsize - leave)))
    return filler


def drill(job, mount, sizes):
    """Counts of old, new and bad ends over the sizes."""
    job.prepare()
    size = sum(path.stat().st_size for path in job.output.rglob("*") if path.is_file())
    counts = {"old": 0, "new": 0, "bad": 0}
    for k in range(sizes):
        job.restore()
        filler = fill(mount, k * 3 * max(size, 65536) // sizes)
        done = common.run(job.new)
        state = job.state()
        filler.unlink()
        names_file = str(job.output.parent) in done.stderr
        good = state == "new" if done.returncode == 0 else state == "old" and names_file
        if job.can_be_repeated():
            good = good and common.run(job.new).returncode == 0
        counts[state if good else "bad"] += 1
        if not good:
            print("  ", k, state, done.returncode, done.stderr.strip()[-200:])
    return counts


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    sizes = int(sys.argv[2]) if len(sys.argv) > 2 else 50
    if os.geteuid() != 0:
        print("TOTAL disk: skipped, needs root to mount a tmpfs")
        return 77
    bad = 0
    with common.scratch() as folder:
        mount = pathlib.Path(folder)
        options = ["-t", "tmpfs", "-o", "size=64m", "tmpfs", str(mount)]
        if subprocess.run(["mount", *options], check=False).returncode != 0:
            print("TOTAL disk: skipped, a tmpfs cannot be mounted here")
            return 77
        try:
            for job in common.jobs(mount, frames, sys.argv[3:]):
                counts = drill(job, mount, sizes)
                bad += counts["bad"]
                print(f"{job.name}: {counts}", flush=True)
        finally:
            subprocess.run(["umount", "-l", str(mount)], check=False)
    print(f"TOTAL disk: bad {bad}")
    return 1 if bad else 0


sys.exit(main())

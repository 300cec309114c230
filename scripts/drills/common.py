# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the drills share: the programs, inputs made by radive_simulate, and judging a folder."""

import hashlib
import os
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = pathlib.Path(os.environ.get("RADIVE_BUILD", ROOT / "build" / "apps"))
RAW = "--set=input.format=raw,input.layout=xyzdp5"


class Job:
    """A program with the command of its earlier and of its new run into the folder `output`."""

    def __init__(self, name, output, earlier, new):
        self.name, self.output, self.earlier, self.new = name, output, earlier, new

    def make(self, command):
        """Runs into an empty place; the folder's content."""
        shutil.rmtree(self.output, ignore_errors=True)
        if command:
            run(command, check=True)
        return content(self.output)

    def prepare(self):
        self.is_new = self.make(self.new)
        self.is_old = self.make(self.earlier)
        self.saved = self.output.with_name("saved")
        shutil.rmtree(self.saved, ignore_errors=True)
        if self.output.exists():
            shutil.copytree(self.output, self.saved)

    def restore(self):
        for path in (self.output, self.output.with_name(f".{self.output.name}.radive")):
            shutil.rmtree(path, ignore_errors=True)
        if self.saved.exists():
            shutil.copytree(self.saved, self.output)

    def can_be_repeated(self):
        """radive_simulate does not write over a drive."""
        return self.earlier is not None or self.state() == "old"

    def state(self):
        now = content(self.output)
        return "old" if now == self.is_old else "new" if now == self.is_new else "mixed"


def content(folder):
    """Hashes of what others read: not of hidden files, nor of what varies between equal runs."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if name.startswith(".") or path.is_dir():
            continue
        data = path.read_bytes()
        if path.name == "timing.csv":
            data = str(data.count(b"\n")).encode()
        elif path.name == "run.json":
            data = next(line for line in data.splitlines() if b'"frames"' in line)
        found[name] = hashlib.sha256(data).hexdigest()
    return found


def run(command, check=False, **options):
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, timeout=600, **options
    )
    if check and done.returncode != 0:
        raise SystemExit(f"{command}: {done.returncode}: {done.stderr}")
    return done


def jobs(work, frames, names):
    """radive_odometry and radive_report into folders with earlier results, radive_simulate anew.

    Those of `names`; all of them where it is empty."""
    drive = work / "drive"
    simulate = [PROGRAMS / "radive_simulate", "--scenario=street_sparse", f"--frames={frames}"]
    simulate.append("--set=simulation.rate=4")
    run([*simulate, f"--output={drive}"], check=True)
    odometry = [PROGRAMS / "radive_odometry", f"--input={drive}", "--quiet"]
    out = work / "odometry" / "out"
    run([*odometry, RAW, f"--output={work / 'run'}"], check=True)
    report = [PROGRAMS / "radive_report", work / "run", f"--reference={drive}/gt_tum.txt"]
    page = work / "report" / "out"
    copy = work / "simulate" / "out"
    every = [
        Job(
            "radive_odometry",
            out,
            [*odometry, RAW, f"--frames={frames // 2}", f"--output={out}"],
            [*odometry, f"{RAW},output.map=none", f"--output={out}"],
        ),
        Job("radive_simulate", copy, None, [*simulate, f"--output={copy}"]),
        Job(
            "radive_report",
            page,
            [*report, "--title=earlier", f"--output={page}"],
            [*report, "--title=new", f"--output={page}"],
        ),
    ]
    return [job for job in every if not names or job.name in names]


def scratch():
    return tempfile.TemporaryDirectory(prefix="radive_drill_")

#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damages drives and trajectories at random and runs the programs on them.

  scripts/drill_mutations.py [--programs=build/apps] [--inputs=5000] [--trajectories=1000]

Drives are those that radive_simulate writes, in every one of its forms, and RadarScenes' HDF5 files
of one where Debian's python3-h5py is there; each mutant has one file
damaged in one way (bits, bytes, digits, lines, blocks, cuts, exchanged or absent files), from a
fixed seed. Bad are: a crash, an abort, a run of more than 20 s, more than 256 MB, a failure without
a message, and a silent error: exit status 0, no warning, no skipped scan, but another number of
scans, or a pose (of trajectories: a root mean square error) more than 1 m from that of the whole
file. Ends with a line "TOTAL ... bad N"; exit status 1 when there were kills or too many silent
errors (more than 0.2 %).
"""

import argparse
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "drills"))
import radarscenes_hdf5  # noqa: E402

NUM_SCANS = 20
LONGEST_RUN = 20.0  # [s]
MOST_MEMORY = 256.0  # [MB]
LARGEST_ERROR = 1.0  # [m]
MOST_SILENT = 0.002  # share of the mutants
NOT_READ = ("labels", "scenario.json", "gt_tum.txt")  # by radive_odometry
HDF5 = {"hdf5": None, "hdf5_gzip": "gzip"}  # form: compression


class Run:
    """One run of a program: status (negative: of a signal), both streams, MB and s."""

    def __init__(self, arguments):
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            begin = time.monotonic()
            process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                       preexec_fn=limit)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = 0
            self.seconds = time.monotonic() - begin
            self.status = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
            self.megabytes = usage.ru_maxrss / 1024
            self.out, self.err = (read_all(stream) for stream in (out, err))

    def kill(self):
        """What is wrong with how it ended; empty: nothing."""
        if self.status in (-signal.SIGXCPU, -signal.SIGALRM):
            return "hang"
        if self.status < 0 or self.status >= 126:
            return f"signal {self.status}"
        if self.megabytes > MOST_MEMORY:
            return f"{self.megabytes:.0f} MB"
        if self.status != 0 and not self.err.strip():
            return "failure without a message"
        return ""


def limit():
    # CPU time, so that a busy machine is no hang; the alarm is for those that wait.
    seconds = int(LONGEST_RUN)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    signal.alarm(10 * seconds)


def read_all(stream):
    stream.seek(0)
    return stream.read().decode("utf-8", "replace")


# Each takes the bytes of a file and gives those of the damaged one.


def flip_bit(data, rng):
    place = rng.randrange(len(data))
    return data[:place] + bytes([data[place] ^ 1 << rng.randrange(8)]) + data[place + 1:]


def set_bytes(data, rng):
    place = rng.randrange(len(data))
    count = rng.choice((1, 2, 4, 8))
    value = rng.choice((b"\0", b"\xff", b"\x7f", b"\x80", bytes([rng.randrange(256)])))
    return data[:place] + (value * count)[:len(data) - place] + data[place + count:]


def insert_bytes(data, rng):
    place = rng.randrange(len(data) + 1)
    return data[:place] + rng.randbytes(rng.choice((1, 2, 7, 64))) + data[place:]


def cut_end(data, rng):
    return data[:rng.randrange(len(data))]


def block(data, rng):
    begin = rng.randrange(len(data))
    return begin, min(len(data), begin + rng.choice((4, 20, 512, 4096)))


def zero_block(data, rng):
    begin, end = block(data, rng)
    return data[:begin] + bytes(end - begin) + data[end:]


def lose_block(data, rng):
    begin, end = block(data, rng)
    return data[:begin] + data[end:]


def repeat_block(data, rng):
    begin, end = block(data, rng)
    return data[:end] + data[begin:]


def change_digit(data, rng):
    places = [match.start() for match in re.finditer(rb"[0-9]", data)]
    if not places:
        return flip_bit(data, rng)
    place = rng.choice(places)
    return data[:place] + rng.choice(b"0123456789.-e,x ").to_bytes(1, "big") + data[place + 1:]


def change_lines(data, rng):
    lines = data.splitlines(keepends=True)
    place = rng.randrange(len(lines))
    how = rng.randrange(3)
    if how == 0:
        del lines[place]
    elif how == 1:
        lines.insert(place, lines[place])
    else:
        other = rng.randrange(len(lines))
        lines[place], lines[other] = lines[other], lines[place]
    return b"".join(lines)


BINARY = (flip_bit, set_bytes, insert_bytes, cut_end, zero_block, lose_block, repeat_block)
TEXT = (change_digit, change_digit, change_lines)


def damage(data, rng):
    """(name of the way, damaged bytes)."""
    if not data:
        return "insert_bytes", insert_bytes(data, rng)
    is_text = all(byte < 128 for byte in data[:256]) and b"\n" in data[:4096]
    way = rng.choice(BINARY + (TEXT * 3 if is_text else ()))
    return way.__name__, way(data, rng)


def link_copy(source, target):
    """Copy of a folder that shares its files."""
    shutil.copytree(source, target, copy_function=os.link)


def make_mutant(source, files, target, rng):
    """The drive with one file damaged; says which and how."""
    shutil.rmtree(target, ignore_errors=True)
    link_copy(source, target)
    name = rng.choice(files)
    path = target / name
    data = path.read_bytes()
    path.unlink()  # not written into: it is shared
    what = rng.randrange(20)
    if what == 0:
        return f"{name}: absent"
    if what == 1:
        other = rng.choice(files)
        path.write_bytes((source / other).read_bytes())
        return f"{name}: content of {other}"
    if what == 2:
        path.write_bytes(b"")
        return f"{name}: empty"
    way, data = damage(data, rng)
    path.write_bytes(data)
    return f"{name}: {way}"


def positions(file):
    return [tuple(map(float, line.split()[1:4])) for line in file.read_text().splitlines()]


class Drives:
    """Mutants of drives, in all forms of radive_simulate."""

    def __init__(self, programs, folder):
        self.odometry = programs / "radive_odometry"
        self.output = folder / "results"
        self.mutant = folder / "mutant"
        simulate = programs / "radive_simulate"
        text = subprocess.run([simulate, "--help"], stdout=subprocess.PIPE, text=True).stdout
        text = re.sub(r"\([^)]*\)", "", re.sub(r"\s+", " ", text))
        forms = re.search(r"Form of the scans: ([^.]*)\.", text).group(1)
        self.forms = [form.strip() for form in forms.split("|")]
        if radarscenes_hdf5.h5py:
            self.forms += HDF5
        else:
            print("no HDF5 files: python3-h5py is missing")
        self.drives = {}
        for form in self.forms:
            drive = folder / "drives" / form
            self.write_drive(simulate, form, drive)
            files = sorted(str(path.relative_to(drive)) for path in drive.rglob("*")
                           if path.is_file() and path.relative_to(drive).parts[0] not in NOT_READ)
            # A table of stamps is one file of many, but matters as much as all scans together.
            tables = [name for name in files if not re.search(r"\d{3,}\.\w+$", name)]
            if len(files) > 4 * len(tables):
                files += tables * (len(files) // max(1, 2 * len(tables)))
            run = self.run(form, drive)
            if run.status != 0:
                sys.exit(f"drill_mutations.py: {form}: {run.err}")
            # Some forms are odd as they are, such as bags without an index.
            self.drives[form] = (drive, files, self.poses(), self.report()["num_warnings"])

    def write_drive(self, simulate, form, drive):
        is_hdf5 = form in HDF5
        written = drive.with_name(form + "_raw") if is_hdf5 else drive
        subprocess.run([simulate, f"--scenario=street_{'planar' if is_hdf5 else 'sparse'}",
                        f"--frames={NUM_SCANS}", "--set=simulation.rate=5,simulation.returns=60",
                        f"--format={'raw' if is_hdf5 else form}", f"--output={written}"],
                       check=True, stdout=subprocess.DEVNULL)
        if is_hdf5:
            radarscenes_hdf5.write(written, drive, HDF5[form])

    def run(self, form, drive):
        shutil.rmtree(self.output, ignore_errors=True)
        layout = ["--set=input.layout=xyzdp5"] if form == "raw" else []
        layout += ["--set=input.radar=2"] if form in HDF5 else []
        return Run([self.odometry, f"--input={drive}", f"--output={self.output}", "--quiet",
                    *layout])

    def report(self):
        return json.loads((self.output / "run.json").read_text())

    def poses(self):
        return positions(self.output / "trajectory_tum.txt")

    def try_one(self, number, rng):
        """(what was done, what is wrong, is it silent)."""
        form = self.forms[number % len(self.forms)]
        drive, files, expected, num_warnings = self.drives[form]
        what = f"{form} {make_mutant(drive, files, self.mutant, rng)}"
        run = self.run(form, self.mutant)
        if run.kill() or run.status != 0:
            return what, run.kill(), False
        report = self.report()
        if report["num_warnings"] > num_warnings or report["status"]["skipped"] > 0:
            return what, "", False
        found = self.poses()
        if len(found) != len(expected):
            return what, f"{len(found)} scans, no warning", True
        error = max(sum((a - b)**2 for a, b in zip(p, q))**0.5 for p, q in zip(found, expected))
        return what, f"{error:.2f} m, no warning" if error > LARGEST_ERROR else "", True


class Trajectories:
    """Mutants of a reference or an estimate, as TUM, KITTI, EuRoC or table of more columns."""

    def __init__(self, programs, folder):
        self.evaluate = programs / "radive_evaluate"
        self.folder = folder / "trajectories"
        self.folder.mkdir()
        subprocess.run([programs / "radive_simulate", "--scenario=street_sparse", "--frames=200",
                        "--set=simulation.rate=5,simulation.returns=60", "--output",
                        folder / "truth"], check=True, stdout=subprocess.DEVNULL)
        lines = (folder / "truth" / "gt_tum.txt").read_text().splitlines()
        rows = [line.split() for line in lines if not line.startswith("#")]
        noise = random.Random(5)
        estimate = [[r[0], *(f"{float(v) + noise.gauss(0, 0.05):.6f}" for v in r[1:4]), *r[4:]]
                    for r in rows]
        self.pairs = []
        for name, form in (("tum", tum), ("kitti", kitti), ("euroc", euroc), ("table", table)):
            for kind, poses in (("reference", rows), ("estimate", estimate)):
                (self.folder / f"{name}_{kind}.txt").write_text(
                    "".join(form(row) + "\n" for row in poses))
            self.pairs.append(name)
        self.rmse = {name: self.score(*self.files(name)) for name in self.pairs}
        for name, (run, rmse, warnings) in self.rmse.items():
            if run.status != 0 or warnings:
                sys.exit(f"drill_mutations.py: {name}: {run.err}")

    def files(self, name):
        return [self.folder / f"{name}_{kind}.txt" for kind in ("reference", "estimate")]

    def score(self, reference, estimate):
        run = Run([self.evaluate, f"--reference={reference}", f"--estimate={estimate}",
                   "--align=se3", "--json"])
        if run.status != 0:
            return run, 0.0, []
        report = json.loads(run.out)
        return run, report["rmse"], report["warnings"]

    def try_one(self, number, rng):
        name = self.pairs[number % len(self.pairs)]
        files = self.files(name)
        which = rng.randrange(2)
        way, data = damage(files[which].read_bytes(), rng)
        files[which] = self.folder / "mutant.txt"
        files[which].write_bytes(data)
        what = f"{name} {('reference', 'estimate')[which]}: {way}"
        run, rmse, warnings = self.score(*files)
        if run.kill() or run.status != 0 or warnings:
            return what, run.kill(), False
        error = abs(rmse - self.rmse[name][1])
        return what, f"rmse {error:.2f} m off, no warning" if error > LARGEST_ERROR else "", True


def tum(row):
    return " ".join(row)


def euroc(row):
    seconds, _, rest = row[0].partition(".")
    # Nanoseconds of this century, by which they are told from seconds.
    stamp = f"{int(seconds) + 1400000000}{rest.ljust(9, '0')[:9]}"
    return ",".join([stamp, *row[1:4], row[7], *row[4:7]])


def table(row):
    return ",".join([*row[:4], "0.5", "0.25", *row[4:]])


def kitti(row):
    x, y, z, w = (float(v) for v in row[4:])
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    return " ".join(" ".join([*(f"{v:.9f}" for v in r), t]) for r, t in zip(rows, row[1:4]))


def drill(title, subject, count, seed):
    """Number of (kills, silent errors)."""
    kills = silent = 0
    for number in range(count):
        # Of its own number, so that one can be tried again without those before it.
        what, wrong, is_silent = subject.try_one(number, random.Random(f"{seed} {number}"))
        if wrong:
            silent += is_silent
            kills += not is_silent
            print(f"{title} {number}: {what}: {wrong}", flush=True)
    print(f"{title}: {count} mutants, {kills} kills, {silent} silent errors", flush=True)
    return kills, silent


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=pathlib.Path("build/apps"))
    parser.add_argument("--inputs", type=int, default=5000)
    parser.add_argument("--trajectories", type=int, default=1000)
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    kills = silent = 0
    with tempfile.TemporaryDirectory(prefix="radive_drill_") as name:
        folder = pathlib.Path(name)
        for title, kind, count in (("input", Drives, options.inputs),
                                   ("trajectory", Trajectories, options.trajectories)):
            if count == 0:
                continue
            k, s = drill(title, kind(options.programs.resolve(), folder), count, options.seed)
            kills, silent = kills + k, silent + s
    count = options.inputs + options.trajectories
    too_many = max(0, silent - int(MOST_SILENT * count))
    print(f"TOTAL {count} mutants, {kills} kills, {silent} silent errors "
          f"({100 * silent / max(1, count):.2f} %, at most 0.2 %), bad {kills + too_many}")
    sys.exit(1 if kills + too_many > 0 else 0)


if __name__ == "__main__":
    main()

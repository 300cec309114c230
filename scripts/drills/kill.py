#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kills programs with SIGKILL while they replace earlier results: the folder holds old or new, whole.

  kill.py [RANDOM_KILLS] [FRAMES] [PROGRAM ...]

Before every call that changes a name, by a preloaded library, and at random moments. The same
command must work afterwards.
"""

import collections
import os
import pathlib
import random
import subprocess
import sys
import time

import common

CALLS = {
    "rename": "const char *a, const char *b",
    "renameat": "int a, const char *b, int c, const char *d",
    "renameat2": "int a, const char *b, int c, const char *d, unsigned e",
    "link": "const char *a, const char *b",
    "linkat": "int a, const char *b, int c, const char *d, int e",
    "unlink": "const char *a",
    "unlinkat": "int a, const char *b, int c",
    "rmdir": "const char *a",
}
HEAD = """#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>
static void count(void) {
  static int n;
  const char *k = getenv("KILL_BEFORE_CALL");
  if (k && ++n == atoi(k)) kill(getpid(), SIGKILL);
}
"""


def build_library(work):
    source, library = work / "kill.c", work / "kill.so"
    text = HEAD
    for name, parameters in CALLS.items():
        names = ", ".join(part.split()[-1].lstrip("*") for part in parameters.split(","))
        text += (
            f"int {name}({parameters}) {{\n  count();\n"
            f'  return ((int (*)({parameters}))dlsym(RTLD_NEXT, "{name}"))({names});\n}}\n'
        )
    source.write_text(text, encoding="utf-8")
    subprocess.run(["cc", "-shared", "-fPIC", "-w", "-o", library, source, "-ldl"], check=True)
    return library


def at_each_call(job, library, states):
    for k in range(1, 400):
        job.restore()
        environment = {**os.environ, "LD_PRELOAD": str(library), "KILL_BEFORE_CALL": str(k)}
        done = common.run(job.new, env=environment)
        states[job.state()] += 1
        if done.returncode == 0:
            return k - 1
        if k % 7 == 1:
            again(job, states)
    return k


def at_random(job, kills, states):
    job.restore()
    begin = time.monotonic()
    common.run(job.new, check=True)
    seconds = time.monotonic() - begin
    chance = random.Random(1)
    for k in range(kills):
        job.restore()
        child = subprocess.Popen(
            [str(part) for part in job.new],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        time.sleep(chance.uniform(0.8 if k % 3 == 0 else 0.0, 1.05) * seconds)
        child.kill()
        child.wait()
        states[job.state()] += 1
        if k % 10 == 0:
            again(job, states)


def again(job, states):
    """The same command once more, over what the kill has left."""
    if not job.can_be_repeated():
        return
    done = common.run(job.new)
    clean = done.returncode == 0 and job.state() == "new"
    left = [path.name for path in job.output.parent.iterdir() if path.name.startswith(".")]
    states["again" if clean and not left else "again_failed"] += 1


def main():
    kills = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    bad = 0
    with common.scratch() as folder:
        work = pathlib.Path(folder)
        library = build_library(work)
        for job in common.jobs(work, frames, sys.argv[3:]):
            states = collections.Counter()
            job.prepare()
            calls = at_each_call(job, library, states)
            at_random(job, kills, states)
            bad += states["mixed"] + states["again_failed"]
            figures = ", ".join(f"{name} {count}" for name, count in sorted(states.items()))
            print(f"{job.name}: {calls} calls, {kills} random moments: {figures}", flush=True)
    print(f"TOTAL kill: bad {bad}")
    return 1 if bad else 0


sys.exit(main())

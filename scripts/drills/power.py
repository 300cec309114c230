#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts the power, on paper: replays the order of writes, and drops what was not synced.

  power.py [FRAMES] [PROGRAM ...]

strace records what a program does. After each call the power may go: then of the changes of names any
number may be on the disk, in their order, but at least those before the last sync of a folder; a
file is whole when it was synced after its last write. Each such state of the output folder must
hold the old or the new results, whole. Not replayed: disks that lie about syncs, file systems that
change the order of names.
"""

import pathlib
import re
import shutil
import subprocess
import sys

import common

NAMES = "mkdir,mkdirat,rename,renameat,renameat2,link,linkat,unlink,unlinkat,rmdir"
TRACED = f"openat,open,creat,write,writev,pwrite64,ftruncate,fsync,fdatasync,syncfs,{NAMES}"
CALL = re.compile(r"^(?:\[pid +\d+\] |\d+ +)?(\w+)\((.*)\) += (-?\d+)")
QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"')
HANDLE = re.compile(r"^(?:AT_FDCWD|\d+)<([^>]*)>")


class Disk:
    """Names as nested dictionaries; a file is a list [bytes written, of them synced]."""

    def __init__(self, root=None):
        self.root = {}
        for path in sorted(root.rglob("*")) if root else []:
            self.put(str(path), {} if path.is_dir() else ["old", "old"])

    def folder(self, path, make=False):
        node = self.root
        for part in pathlib.PurePosixPath(path).parts[1:]:
            if make:
                node = node.setdefault(part, {})
            else:
                node = node[part]
        return node

    def get(self, path):
        try:
            return self.folder(path)
        except (KeyError, TypeError):
            return None

    def put(self, path, node):
        path = pathlib.PurePosixPath(path)
        self.folder(path.parent, make=True)[path.name] = node

    def take(self, path):
        path = pathlib.PurePosixPath(path)
        return self.folder(path.parent).pop(path.name)


def apply(disk, change):
    kind, *paths = change[:3]
    if kind == "put":
        disk.put(paths[0], {} if change[2] == {} else change[2])
    elif kind == "link":
        disk.put(paths[1], disk.get(paths[0]))
    elif kind == "rename":
        disk.put(paths[1], disk.take(paths[0]))
    elif kind == "exchange":
        a, b = disk.take(paths[0]), disk.take(paths[1])
        disk.put(paths[0], b)
        disk.put(paths[1], a)
    elif kind == "remove":
        disk.take(paths[0])


def paths_of(arguments):
    """Absolute paths of a call, in order."""
    found, base = [], None
    for part in re.split(r",\s*(?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", arguments):
        handle, name = HANDLE.match(part), QUOTED.match(part)
        if handle:
            base = handle.group(1)
        elif name:
            found.append(str(pathlib.PurePosixPath(base or "/") / name.group(1)))
            base = None
    return found


def change_of(call, arguments, live):
    """What the call does to names, as a tuple for apply(); None when nothing."""
    paths = paths_of(arguments)
    if call in ("mkdir", "mkdirat"):
        return ("put", paths[0], {})
    if call in ("open", "openat", "creat") and "O_CREAT" in arguments:
        return None if live.get(paths[0]) is not None else ("put", paths[0], [0, 0])
    if call in ("link", "linkat"):
        return ("link", *paths[:2])
    if call.startswith("rename"):
        return ("exchange" if "RENAME_EXCHANGE" in arguments else "rename", *paths[:2])
    if call in ("unlink", "unlinkat", "rmdir"):
        return ("remove", paths[0])
    return None


def visible(disk, output):
    """Name to file of what others read in the folder, with those below."""
    found = {}

    def walk(node, prefix):
        for name, below in node.items():
            if prefix == "" and name.startswith("."):
                continue
            if isinstance(below, dict):
                walk(below, f"{prefix}{name}/")
            else:
                found[prefix + name] = below

    walk(disk.get(str(output)) or {}, "")
    return found


def sync_below(node):
    for below in node.values() if isinstance(node, dict) else []:
        sync_below(below)
    if isinstance(node, list):
        node[1] = node[0]


def replay(lines, live, root, job):
    """The number of states that were judged, and those that hold neither old nor new."""
    pending, judged, bad = [], 0, []
    # The same lists stand for the files in both, so that a sync is seen from either.
    durable = Disk()
    durable.root = copy_names(live.root)
    for line in lines:
        match = CALL.match(line)
        if not match or int(match.group(3)) < 0 or str(root) not in line:
            continue
        call, arguments = match.group(1), match.group(2)
        change = change_of(call, arguments, live)
        if change:
            apply(live, change)
            pending.append(change)
        handle = HANDLE.match(arguments)
        node = live.get(handle.group(1)) if handle else None
        if call in ("write", "writev", "pwrite64", "ftruncate") and isinstance(node, list):
            node[0] = 1 if node[0] == "old" else node[0] + 1
        elif call in ("open", "openat") and "O_TRUNC" in arguments and not change:
            truncated = live.get(paths_of(arguments)[0])
            if isinstance(truncated, list):
                truncated[0] = 1
                truncated[1] = 0
        elif call in ("fsync", "fdatasync") and isinstance(node, list):
            node[1] = node[0]
        elif call in ("fsync", "syncfs"):
            if call == "syncfs":
                sync_below(live.root)
            for done in pending:
                apply(durable, done)
            pending = []
        state = Disk()
        state.root = copy_names(durable.root)
        for k in range(len(pending) + 1):
            if k > 0:
                apply(state, pending[k - 1])
            judged += 1
            wrong = what_is_wrong(visible(state, job.output), job)
            if wrong:
                bad.append((line.strip()[:120], wrong))
    return judged, bad


def what_is_wrong(files, job):
    if torn := sorted(name for name, file in files.items() if file[0] != file[1]):
        return f"not synced: {torn[:3]}"
    are_old = {file[0] == "old" for file in files.values()}
    if len(are_old) > 1:
        return "old beside new"
    if files.keys() != (job.is_new if are_old == {False} else job.is_old).keys():
        return f"not all files: {sorted(files)[:3]}"
    return ""


def copy_names(node):
    return (
        {name: copy_names(below) for name, below in node.items()}
        if isinstance(node, dict)
        else node
    )


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    strace = shutil.which("strace")
    if not strace or subprocess.run([strace, "-o", "/dev/null", "true"], check=False).returncode:
        print("TOTAL power: skipped, strace cannot be used here")
        return 77
    worst = 0
    with common.scratch() as folder:
        work = pathlib.Path(folder).resolve()
        for job in common.jobs(work, frames, sys.argv[2:]):
            job.prepare()
            job.restore()
            root = job.output.parent
            root.mkdir(exist_ok=True)
            log = work / "strace.log"
            command = [strace, "-f", "-y", "-s", "0", "-e", f"trace={TRACED}", "-o", log, *job.new]
            live = Disk(root)
            common.run(command, check=True, cwd="/")
            with open(log, encoding="utf-8", errors="replace") as lines:
                judged, bad = replay(lines, live, root, job)
            worst += len(bad)
            print(f"{job.name}: {judged} states after a power cut, {len(bad)} neither old nor new")
            for entry in bad[:3]:
                print("  ", *entry)
    print(f"TOTAL power: bad {worst}")
    return 1 if worst else 0


sys.exit(main())

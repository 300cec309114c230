# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The real drives that the studies of faults run on, and copies of them with changed scans.

The drives are research-only and no part of the project: a folder `shared` beside the checkout has
them, where it is there at all.
"""
import glob
import os

import numpy as np

RAW_COLUMNS = {"vod": 3, "mscrad4r": 5, "tj4d": 8}
RAW_FOLDERS = {"vod": "radar", "mscrad4r": "radar", "tj4d": "velodyne"}


def sequences(data):
    """Yields (name, folder below `data`, configuration, settings)."""
    for k in ("04", "06", "12", "24", "26"):
        yield f"vod_{k}", f"vod-radar-xyz/delft_{k}", "vod_xyz.yaml", ""
    for k in ("2", "3", "1", "4", "all"):
        yield f"radarscenes_105_{k}", "radarscenes/seq105", "radarscenes.yaml", f"input.radar={k}"
    for scene in ("0061", "0103", "0796", "1094"):
        with open(f"{data}/nuscenes/{scene}/mounts.csv", encoding="utf-8") as f:
            rows = [line.strip().split(",") for line in f][1:]
        mounts = ",".join(f"{r[0]},{r[2]},{r[3]},0,0,0,{r[5]}" for r in rows)
        for k in ("1", "all"):
            yield (f"nuscenes_{scene}_{k}", f"nuscenes/{scene}", "nuscenes.yaml",
                   f"input.radar={k},sensor.mounts=[{mounts}]")
    yield "mscrad4r_c0", "mscrad4r-urban-c0", "mscrad4r.yaml", ""
    yield "tj4d", "tj4dradset-sample", "tj4dradset.yaml", ""


def is_polar(name):
    """Whether a scan's columns are range [m], azimuth [rad], Doppler, RCS, label; else x, y, z [m] first."""
    return name.startswith(("radarscenes", "nuscenes"))


def copy(name, source, target, change):
    """Copies a drive without its ground truth and labels. `change(scans)` gets all scans of a radar,
    arrays of one row per return, and returns as many; None leaves a scan out."""
    if not is_polar(name):
        kind = name.split("_")[0]
        os.makedirs(f"{target}/{RAW_FOLDERS[kind]}")
        paths = sorted(glob.glob(f"{source}/{RAW_FOLDERS[kind]}/*.bin"))
        scans = [np.fromfile(path, "<f4").reshape(-1, RAW_COLUMNS[kind]) for path in paths]
        for path, scan in zip(paths, change(scans)):
            # The stamps follow from the positions of the files: a scan left out is an empty one.
            (scans[0][:0] if scan is None else scan).astype("<f4").tofile(
                f"{target}/{RAW_FOLDERS[kind]}/{os.path.basename(path)}")
        return
    for path in glob.glob(source + "/*.csv"):
        with open(path, encoding="utf-8") as f:
            lines = f.read().splitlines()
        out = f"{target}/{os.path.basename(path)}"
        if not path.endswith("_scans.csv"):
            with open(out, "w", encoding="utf-8") as f:
                f.write("\n".join(lines) + "\n")
            continue
        points = np.fromfile(path.replace("_scans.csv", "_points.bin"), "<f4").reshape(-1, 5)
        points[:, 4] = 0
        rows = [line.split(",") for line in lines[1:]]
        scans = change([points[int(r[2]):int(r[2]) + int(r[3])] for r in rows])
        first, kept = 0, []
        with open(out, "w", encoding="utf-8") as f:
            f.write(lines[0] + "\n")
            for row, scan in zip(rows, scans):
                if scan is None:
                    continue
                f.write(",".join(row[:2] + [str(first), str(len(scan))] + row[4:5] + ["0"] * 5) + "\n")
                first += len(scan)
                kept.append(scan)
        np.concatenate(kept).astype("<f4").tofile(out.replace("_scans.csv", "_points.bin"))

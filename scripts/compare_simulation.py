#!/usr/bin/python3
"""Compares simulated radar scans with recorded ones, side by side in one table.

  scripts/compare_simulation.py SIMULATED xyzdp5 RECORDED xyzdp5 [FOLDER LAYOUT ...]

Each column may be given a name, NAME=FOLDER. Each FOLDER holds *.bin scans itself or in radar/ or velodyne/; LAYOUT is the record of its files:
xyz3, xyzdp5 (x y z doppler power), vod7, tj4d8, or radarscenes1 .. radarscenes4 for one radar of
a RadarScenes folder. Returns outside the view of the options are left out, so that sensors with
different views can be compared.

Returns a voxel are counted in voxels of 2 x 2 x 1 m, those of single scans that hold any.

The Doppler inliers are those of a RANSAC fit of the ego velocity v to doppler = -d . v, refined
by least squares.
"""

import argparse
import csv
import pathlib
import sys

import numpy as np

# Columns of x y z, of the Doppler and of the power in a record of float32; None: not stored.
LAYOUTS = {
    "xyz3": (3, (0, 1, 2), None, None),
    "xyzdp5": (5, (0, 1, 2), 3, 4),
    "vod7": (7, (0, 1, 2), 4, 3),
    "tj4d8": (8, (0, 1, 2), 3, 5),
}
QUANTILES = (5, 10, 25, 50, 75, 90, 95)


def fail(message):
    sys.exit("compare_simulation.py: " + message)


def read_records(path, columns):
    values = np.fromfile(path, "<f4")
    if values.size % columns:
        fail(f"{path}: size is no multiple of {columns} float32 values")
    return values.reshape(-1, columns).astype(float)


def raw_scans(folder, layout, step):
    """Yields x y z, Doppler and power of every `step`-th scan; None for what is not stored."""
    columns, xyz, doppler, power = LAYOUTS[layout]
    for place in (folder, folder / "radar", folder / "velodyne"):
        paths = sorted(place.glob("*.bin"))
        if paths:
            break
    else:
        fail(f"{folder}: no *.bin scans in it, in radar/ or in velodyne/")
    for path in paths[::step]:
        records = read_records(path, columns)
        yield (records[:, xyz],
               None if doppler is None else records[:, doppler],
               None if power is None else records[:, power])


def radarscenes_scans(folder, radar, step):
    points = read_records(folder / f"radar{radar}_points.bin", 5)
    with open(folder / f"radar{radar}_scans.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows[::step]:
        first = int(row["first_point"])
        scan = points[first:first + int(row["num_points"])]
        position = np.column_stack((scan[:, 0] * np.cos(scan[:, 1]),
                                    scan[:, 0] * np.sin(scan[:, 1]),
                                    np.zeros(len(scan))))
        yield position, scan[:, 2], scan[:, 3]


def fit_velocity(direction, doppler, gate, random):
    """Ego velocity and inlier mask; None when there are too few returns or they do not fix it."""
    if np.all(direction[:, 2] == 0.0):
        direction = direction[:, :2]
    size = direction.shape[1]
    if len(doppler) < 2 * size:
        return None
    best = np.zeros(len(doppler), bool)
    for _ in range(80):
        sample = random.choice(len(doppler), size, replace=False)
        if abs(np.linalg.det(direction[sample])) < 1e-6:
            continue
        velocity = np.linalg.solve(direction[sample], -doppler[sample])
        inliers = np.abs(doppler + direction @ velocity) < gate
        if inliers.sum() > best.sum():
            best = inliers
    if best.sum() < size:
        return None
    for _ in range(3):
        velocity = np.linalg.lstsq(direction[best], -doppler[best], rcond=None)[0]
        refined = np.abs(doppler + direction @ velocity) < gate
        if refined.sum() < size:
            break
        best = refined
    residual = doppler[best] + direction[best] @ velocity
    return velocity, best, np.sqrt(np.mean(residual ** 2))


VOXEL = np.array([2.0, 2.0, 1.0])  # [m]


def returns_per_voxel(position):
    cells = np.floor(position / VOXEL).astype(np.int64)
    return np.unique(cells, axis=0, return_counts=True)[1]


def measure(scans, options):
    random = np.random.default_rng(1)
    counts, ranges, azimuths, elevations, powers = [], [], [], [], []
    shares, deviations, speeds, voxels = [], [], [], []
    for position, doppler, power in scans:
        distance = np.linalg.norm(position, axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            azimuth = np.degrees(np.arctan2(position[:, 1], position[:, 0]))
            elevation = np.degrees(np.arcsin(position[:, 2] / distance))
            keep = ((distance >= options.min_range) & (distance <= options.max_range) &
                    (np.abs(azimuth) <= options.azimuth) & (np.abs(elevation) <= options.elevation))
        if doppler is not None:
            keep &= np.isfinite(doppler)
        counts.append(keep.sum())
        voxels.append(returns_per_voxel(position[keep]))
        ranges.append(distance[keep])
        azimuths.append(azimuth[keep])
        elevations.append(elevation[keep])
        if power is not None:
            powers.append(power[keep])
        if doppler is None:
            continue
        fit = fit_velocity(position[keep] / distance[keep, None], doppler[keep], options.gate, random)
        if fit is not None:
            speeds.append(np.linalg.norm(fit[0]))
            shares.append(fit[1].mean())
            deviations.append(fit[2])
    if not counts or sum(counts) == 0:
        fail("no returns within the view")
    all_ranges = np.concatenate(ranges)
    rows = {
        "scans": f"{len(counts)}",
        "returns a scan, mean": f"{np.mean(counts):.0f}",
        "returns a scan, std": f"{np.std(counts):.0f}",
        "returns a scan, min - max": f"{min(counts)} - {max(counts)}",
        "range, mean [m]": f"{all_ranges.mean():.1f}",
    }
    for quantile in QUANTILES:
        rows[f"range, {quantile} % [m]"] = f"{np.percentile(all_ranges, quantile):.1f}"
    for name, values in (("azimuth", azimuths), ("elevation", elevations)):
        low, middle, high = np.percentile(np.concatenate(values), (10, 50, 90))
        rows[f"{name}, 10 / 50 / 90 % [deg]"] = f"{low:.1f} / {middle:.1f} / {high:.1f}"
    per_voxel = np.concatenate(voxels)
    rows["returns a voxel, mean"] = f"{per_voxel.mean():.2f}"
    rows["voxels of one return [%]"] = f"{100 * np.mean(per_voxel == 1):.0f}"
    rows["returns a voxel, 90 / 99 %"] = " / ".join(
        f"{value:.0f}" for value in np.percentile(per_voxel, (90, 99)))
    if powers:
        low, middle, high = np.percentile(np.concatenate(powers), (10, 50, 90))
        rows["power, 10 / 50 / 90 % [dB]"] = f"{low:.1f} / {middle:.1f} / {high:.1f}"
    if shares:
        rows["Doppler inliers, mean [%]"] = f"{100 * np.mean(shares):.1f}"
        rows["Doppler inliers, 10 / 90 % [%]"] = " / ".join(
            f"{100 * value:.1f}" for value in np.percentile(shares, (10, 90)))
        rows["Doppler inlier rms [m/s]"] = f"{np.mean(deviations):.3f}"
        rows["speed, min - max [m/s]"] = f"{min(speeds):.1f} - {max(speeds):.1f}"
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("inputs", nargs="+", metavar="FOLDER LAYOUT")
    parser.add_argument("--step", type=int, default=10, help="take every STEP-th scan (10)")
    parser.add_argument("--min_range", type=float, default=1.0, help="[m] (1)")
    parser.add_argument("--max_range", type=float, default=200.0, help="[m] (200)")
    parser.add_argument("--azimuth", type=float, default=56.5, help="half view [deg] (56.5)")
    parser.add_argument("--elevation", type=float, default=22.5, help="half view [deg] (22.5)")
    parser.add_argument("--markdown", action="store_true", help="print the table as Markdown")
    parser.add_argument("--gate", type=float, default=0.3, help="of Doppler inliers [m/s] (0.3)")
    options = parser.parse_args()
    if len(options.inputs) % 2:
        parser.error("every FOLDER needs its LAYOUT")

    columns = []
    for folder, layout in zip(options.inputs[::2], options.inputs[1::2]):
        name, _, folder = folder.rpartition("=")
        path = pathlib.Path(folder)
        if not path.is_dir():
            fail(f"{folder}: no such folder")
        if layout in LAYOUTS:
            scans = raw_scans(path, layout, options.step)
        elif layout in ("radarscenes1", "radarscenes2", "radarscenes3", "radarscenes4"):
            scans = radarscenes_scans(path, int(layout[-1]), options.step)
        else:
            fail(f"layout must be one of {', '.join(LAYOUTS)}, radarscenes1-4, is {layout}")
        columns.append((name or path.resolve().name, measure(scans, options)))

    names = list(dict.fromkeys(name for _, rows in columns for name in rows))
    width = max(len(name) for name in names)
    if options.markdown:
        print("| | " + " | ".join(label for label, _ in columns) + " |")
        print("| --- |" + " --- |" * len(columns))
        for name in names:
            print(f"| {name} | " + " | ".join(rows.get(name, "-") for _, rows in columns) + " |")
        return
    table = [[label] + [rows.get(name, "-") for name in names] for label, rows in columns]
    widths = [max(len(cell) for cell in column) for column in table]
    for i, name in enumerate([""] + names):
        print("  ".join([name.ljust(width)] + [c[i].rjust(w) for c, w in zip(table, widths)]))


if __name__ == "__main__":
    main()

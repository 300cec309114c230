# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of the files in a results folder of radive_odometry. SI units, as in the files."""

import csv
import io
import json

import numpy as np


class FileError(Exception):
    """A file that is missing or not what it should be: names file, place and expectation."""


PLY_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
    "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip


def read_text(path):
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise FileError(f"{path}: cannot be read: {error}") from error


def read_tum(path):
    """N x 8: t x y z qx qy qz qw [s, m, -]."""
    rows = []
    for number, line in enumerate(read_text(path).splitlines(), 1):
        fields = line.split("#")[0].split()
        if not fields:
            continue
        try:
            rows.append([float(field) for field in fields])
        except ValueError:
            rows.append([])
        if len(rows[-1]) != 8 or not np.isfinite(rows[-1]).all():
            raise FileError(f"{path}:{number}: expected 8 numbers: t x y z qx qy qz qw")
    if not rows:
        raise FileError(f"{path}: no poses, expected lines of t x y z qx qy qz qw")
    poses = np.array(rows)
    norms = np.linalg.norm(poses[:, 4:], axis=1, keepdims=True)
    if not norms.all():
        raise FileError(f"{path}: a quaternion is zero")
    poses[:, 4:] /= norms
    return poses


def read_ply(path):
    """The vertices of a binary little-endian or ascii PLY: a dictionary of one array a property."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error}") from error
    end = data.find(b"end_header\n")
    if not data.startswith(b"ply") or end < 0:
        raise FileError(f"{path}: not a PLY file, expected 'ply' ... 'end_header'")
    element, count, fields, is_ascii = None, 0, [], False
    for line in data[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            is_ascii = words[1] == "ascii"
            if words[1] == "binary_big_endian":
                raise FileError(f"{path}: expected ascii or binary_little_endian")
        elif words[:1] == ["element"]:
            if element is None and words[1] != "vertex":
                raise FileError(f"{path}: the first element must be vertex, is {words[1]}")
            element = words[1]
            count = int(words[2]) if element == "vertex" else count
        elif words[:1] == ["property"] and element == "vertex":
            if words[1] not in PLY_TYPES:
                raise FileError(f"{path}: vertices with a property of type {words[1]}")
            fields.append((words[2], "<" + PLY_TYPES[words[1]]))
    body = data[end + len(b"end_header\n") :]
    try:
        if is_ascii:
            return read_ascii_vertices(body, count, fields)
        vertices = np.frombuffer(body, np.dtype(fields), count)
    except (ValueError, IndexError) as error:
        raise FileError(f"{path}: expected {count} vertices: {error}") from error
    return {name: vertices[name] for name, _ in fields}


def read_ascii_vertices(body, count, fields):
    lines = body.decode("ascii", "replace").splitlines()[:count]
    rows = np.array([line.split()[: len(fields)] for line in lines], float)
    if rows.shape != (count, len(fields)):
        raise ValueError(f"{len(lines)} lines are left")
    return {name: rows[:, i] for i, (name, _) in enumerate(fields)}


def read_points(path):
    """N x 3 [m]: the finite vertices of a PLY."""
    vertices = read_ply(path)
    if not {"x", "y", "z"} <= vertices.keys():
        raise FileError(f"{path}: vertices have no x, y, z")
    points = np.stack([vertices[axis] for axis in "xyz"], -1).astype(float)
    return points[np.isfinite(points).all(axis=1)]


def read_csv(path, needed=()):
    """Rows as dictionaries of texts. `needed` are columns that must be there."""
    reader = csv.DictReader(io.StringIO(read_text(path), newline=""))
    missing = [name for name in needed if name not in (reader.fieldnames or [])]
    if missing:
        raise FileError(f"{path}:1: no column {', '.join(missing)}")
    rows = []
    for row in reader:
        if None in row or None in row.values():
            raise FileError(f"{path}:{reader.line_num}: expected {len(reader.fieldnames)} fields")
        rows.append(row)
    return rows


def read_json(path):
    try:
        return json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise FileError(f"{path}:{error.lineno}: not JSON: {error.msg}") from error


def number(text):
    """A float, NaN where there is none."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return float("nan")

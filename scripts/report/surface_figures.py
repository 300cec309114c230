# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the neural submap: surface points before and after extraction, a slice of the field.

As in the paper blue is positive (the side that the radar saw) and red negative.
"""

import matplotlib.colors
import matplotlib.ticker
import numpy as np

from report import theme

WINDOW, SLICE_WINDOW = 60.0, 40.0  # edges of the squares that are shown [m]
SDF_MAP = matplotlib.colors.LinearSegmentedColormap.from_list(
    "sdf", ["#b2182b", "#d6604d", "#9aa1a9", "#4393c3", "#2166ac"]
)


def window(points, path, edge):
    """Low and high corner (x, y) of the square about the pose with the most points around it."""
    coarse = path[:: max(1, len(path) // 200)]
    half = edge / 2
    counts = [(np.abs(points[:, :2] - pose).max(1) < half).sum() for pose in coarse]
    center = coarse[int(np.argmax(counts))]
    return center - half, center + half


def vertices(ply):
    return np.stack([ply[name].astype(float) for name in ("x", "y", "z", "sdf")], -1)


def inside(points, low, high):
    return points[((points[:, :2] >= low) & (points[:, :2] <= high)).all(1)]


def limits(axes, low, high):
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]")
    axes.set_aspect("equal")
    axes.grid(visible=False)


def colour_bar(figure, drawn, axes):
    bar = figure.colorbar(
        drawn, ax=axes, label="signed distance [m]", location="top", shrink=0.7, pad=0.03, aspect=30
    )
    bar.outline.set_visible(False)
    bar.locator = matplotlib.ticker.MaxNLocator(5, steps=[1, 2, 5])
    bar.update_ticks()


def scale(points):
    """Most of the distances are within this [m]."""
    return max(float(np.percentile(np.abs(points[:, 3]), 90)), 0.02) if len(points) else 1.0


def extraction_figure(run):
    """The neural points before and after the extraction of those on a surface, from above."""
    before, after = run.ply("neural_points.ply"), run.ply("map.ply")
    if before is None or after is None or "sdf" not in after or not len(before["x"]):
        return None
    before, after = vertices(before), vertices(after)
    low, high = window(before, run.estimate[:, 1:3], WINDOW)
    before, after = inside(before, low, high), inside(after, low, high)
    figure, both = theme.new_figure(6.4, 4.2, ncols=2, sharey=True)
    titles = ("before extraction", "after extraction")
    for axes, points, title in zip(both, (before, after), titles):
        order = np.argsort(np.abs(points[:, 3]), kind="stable")[::-1]
        drawn = axes.scatter(
            *points[order, :2].T,
            s=1.6,
            c=points[order, 3],
            cmap=SDF_MAP,
            vmin=-scale(points),
            vmax=scale(points),
            linewidths=0,
            rasterized=True,
        )
        axes.plot(*run.estimate[:, 1:3].T, color=theme.INK[0], linewidth=1)
        axes.set_title(f"{title}: {len(points):,}", fontsize=9)
        limits(axes, low, high)
        colour_bar(figure, drawn, axes)
    both[0].set(ylabel="y [m]")
    return figure


def grid_spacing(vertices_2d):
    """Of a grid that may be turned (a second radar's): the median distance of neighbours [m]."""
    some = vertices_2d[:: max(1, len(vertices_2d) // 200)]
    squared = ((some[:, None] - vertices_2d[None]) ** 2).sum(-1)
    return float(np.sqrt(np.median(np.min(np.where(squared > 1e-6, squared, np.inf), axis=1))))


def slice_figure(run):
    """A horizontal slice through the field, with its zero line."""
    slice_ply = run.ply("sdf_slice.ply")
    if slice_ply is None or len(slice_ply["x"]) < 100:
        return None
    points = vertices(slice_ply)
    low, high = window(points, run.estimate[:, 1:3], SLICE_WINDOW)
    points = inside(points, low, high)
    if len(points) < 20:
        return None
    spacing = grid_spacing(points[:, :2])
    index = np.round((points[:, :2] - low) / spacing).astype(int)
    image = np.full(index.max(0)[::-1] + 1, np.nan)
    image[index[:, 1], index[:, 0]] = points[:, 3]
    figure, axes = theme.new_figure(6.4, 5.6)
    extent = (
        low[0] - spacing / 2, low[0] + (image.shape[1] - 0.5) * spacing,
        low[1] - spacing / 2, low[1] + (image.shape[0] - 0.5) * spacing,
    )  # fmt: skip
    drawn = axes.imshow(
        image, origin="lower", extent=extent, cmap=SDF_MAP, vmin=-1, vmax=1, interpolation="nearest"
    )
    x = low[0] + spacing * np.arange(image.shape[1])
    y = low[1] + spacing * np.arange(image.shape[0])
    if (image < 0).any() and (image > 0).any():
        axes.contour(x, y, image, levels=[0], colors=theme.INK[0], linewidths=0.6)
    axes.plot(*run.estimate[:, 1:3].T, color=theme.SERIES[1][0], linewidth=1.2)
    limits(axes, low, high)
    axes.set(ylabel="y [m]")
    colour_bar(figure, drawn, axes)
    return figure

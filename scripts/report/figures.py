# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of a sequence. Each function returns a matplotlib figure, or None without data."""

import numpy as np

from report import theme
from report.theme import MUTED, TRUTH, new_figure, series_style


MOST_OF_A_LINE = 1500  # poses: more cannot be seen, and the page carries them


def widen(axes):
    """A straight drive is no line without height: the shorter side gets a third of the longer."""
    x, y = axes.get_xlim(), axes.get_ylim()
    least = max(x[1] - x[0], y[1] - y[0]) / 3
    for limits, set_limits in ((x, axes.set_xlim), (y, axes.set_ylim)):
        margin = (least - (limits[1] - limits[0])) / 2
        if margin > 0:
            set_limits(limits[0] - margin, limits[1] + margin)


def view_from_above(low, high, width=6.4, reserve=1.0):
    """A figure whose height fits the area from low to high (x, y) [m], and its axes.

    `reserve` is for what stands above and below the axes [inch].
    """
    span = np.maximum(high - low, 1.0)
    span = np.maximum(span, span.max() / 3)
    center = (np.asarray(low) + high) / 2
    low, high = center - 0.53 * span, center + 0.53 * span
    height = min(6.0, (width - 1.0) * span[1] / span[0]) + reserve
    figure, axes = new_figure(width, height)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]", ylabel="y [m]")
    axes.set_aspect("equal", adjustable="datalim")
    return figure, axes


def legend(axes):
    """Above the axes, so that it never covers a line."""
    _, names = axes.get_legend_handles_labels()
    axes.legend(
        loc="lower left",
        bbox_to_anchor=(0, 1.0),
        ncol=max(1, min(len(names), 88 // (8 + max(map(len, names))))),
        borderaxespad=0.2,
        handlelength=2.2,
        columnspacing=1.4,
    )


def trajectory_figure(runs):
    """Runs of one sequence, one a variant as (index, name, run), over the ground truth."""
    runs = [entry for entry in runs if entry[2] is not None]
    truth = next((run.reference for _, _, run in runs if run.errors), None)
    if truth is not None:
        lines = [(i, name, run.errors.positions) for i, name, run in runs if run.errors]
    else:
        lines = [(i, name, run.estimate[:, 1:4]) for i, name, run in runs]
    if not lines:
        return None
    paths = [positions for _, _, positions in lines]
    # A lost run must not shrink the others to a dot: the ground truth decides, if there is one.
    shown = np.concatenate([truth[:, 1:4]] if truth is not None else paths)[:, :2]
    margin = 0.15 * np.ptp(shown, axis=0).max() if truth is not None else 0
    everything = np.concatenate(paths)[:, :2]
    low = np.maximum(everything.min(0), shown.min(0) - margin)
    high = np.minimum(everything.max(0), shown.max(0) + margin)
    figure, axes = view_from_above(np.minimum(low, shown.min(0)), np.maximum(high, shown.max(0)))
    if truth is not None:
        label = "ground truth"
        path = thinned(truth, MOST_OF_A_LINE)[:, 1:3]
        axes.plot(*path.T, color=TRUTH[0], linewidth=4.5, alpha=0.6, label=label)
    for index, name, positions in lines:
        axes.plot(*thinned(positions, MOST_OF_A_LINE)[:, :2].T, label=name, **series_style(index))
    start = lines[0][2][0]
    axes.plot(*start[:2], "o", color=theme.INK[0], markersize=5, label="start", zorder=5)
    legend(axes)
    return figure


def error_figure(runs):
    """Absolute pose error over the distance travelled."""
    runs = [(index, name, run.errors) for index, name, run in runs if run and run.errors]
    if not runs:
        return None
    figure, (upper, lower) = new_figure(6.4, 4.6, nrows=2, sharex=True)
    for index, name, errors in runs:
        style = series_style(index)
        distance = thinned(errors.distance, MOST_OF_A_LINE)
        upper.plot(distance, thinned(errors.translation, MOST_OF_A_LINE), label=name, **style)
        lower.plot(distance, np.degrees(thinned(errors.rotation, MOST_OF_A_LINE)), **style)
    upper.set(ylabel="position error [m]")
    lower.set(ylabel="rotation error [°]", xlabel="distance travelled [m]")
    for axes in (upper, lower):
        axes.set_ylim(bottom=0)
        axes.margins(x=0.01)
    legend(upper)
    return figure


def ape_figure(variants):
    """Quartiles of the pose errors: (index, name, list of PoseErrors of all seeds) a variant."""
    variants = [(i, name, errors) for i, name, errors in variants if errors]
    if not variants:
        return None
    figure, both = new_figure(6.4, max(2.2, 1.1 + 0.42 * len(variants)), ncols=2, sharey=True)
    units = (
        ("translation", 1.0, "APE translation [m]"),
        ("rotation", 180 / np.pi, "APE rotation [°]"),
    )
    for axes, (attribute, factor, label) in zip(both, units):
        values = [
            factor * np.concatenate([getattr(errors, attribute) for errors in all_errors])
            for _, _, all_errors in variants
        ]
        boxes = axes.boxplot(
            values,
            vert=False,
            whis=(5, 95),
            showfliers=False,
            widths=0.58,
            patch_artist=True,
            medianprops={"color": theme.INK[0], "linewidth": 1.8},
            whiskerprops={"color": MUTED[0]},
            capprops={"color": MUTED[0]},
        )
        for (index, _, _), box in zip(variants, boxes["boxes"]):
            colour = series_style(index)["color"]
            box.set(facecolor=colour, edgecolor=colour, alpha=0.55)
        axes.set(xlabel=label, xlim=(0, None))
        axes.set_yticks(range(1, len(variants) + 1), [name for _, name, _ in variants])
        axes.grid(visible=False, axis="y")
        axes.tick_params(axis="y", length=0)
    both[0].invert_yaxis()
    return figure


def rolling(values, window, function):
    """The function over a centred window, shorter at both ends."""
    half = window // 2
    padded = np.concatenate([np.full(half, np.nan), values, np.full(half, np.nan)])
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * half + 1)
    return function(windows, axis=1)


def time_figure(runs, limit_ms):
    """Milliseconds of a scan, with the time that the sensor leaves for it."""
    runs = [(index, name, run) for index, name, run in runs if run and run.times]
    if not runs:
        return None
    figure, axes = new_figure(6.4, 3.2)
    lowest = np.inf
    for index, name, run in runs:
        total = run.times["odometry_ms"]
        style = series_style(index)
        window = min(25, 2 * (len(total) // 8) + 1)
        if len(runs) <= 2:
            axes.plot(total, ".", color=style["color"], markersize=2, alpha=0.35, rasterized=True)
        smooth = rolling(total, window, np.nanmedian)
        scans = thinned(np.arange(len(smooth)), MOST_OF_A_LINE)
        axes.plot(scans, smooth[scans], label=name, **style)
        lowest = min(lowest, np.nanmin(smooth))
    if limit_ms:
        axes.axhline(limit_ms, color=theme.LIMIT[0], linewidth=1.2, linestyle=(0, (1, 1.5)))
        axes.annotate(
            f"real time: {limit_ms:.0f} ms",
            (1, limit_ms),
            xycoords=("axes fraction", "data"),
            xytext=(0, 3),
            textcoords="offset points",
            ha="right",
            color=theme.LIMIT[0],
        )
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    top = max(axes.get_ylim()[1], (limit_ms or 0) * 2)
    axes.set_ylim(max(lowest / 2, 0.01), top)
    axes.margins(x=0.01)
    axes.set(xlabel="scan", ylabel="time per scan [ms]")
    legend(axes)
    return figure


def map_figure(run, most_points=60000):
    """The keyframes' points from above, coloured by height, with the trajectory."""
    if run is None or not len(run.map_points):
        return None
    points = thinned(run.map_points, most_points)
    path = run.estimate[:, 1:3]
    corners = np.percentile(points[:, :2], [0.3, 99.7], axis=0)
    low, high = np.minimum(corners[0], path.min(0)), np.maximum(corners[1], path.max(0))
    figure, axes = view_from_above(low, high, reserve=1.3)
    lowest, highest = height_limits(points)
    order = np.argsort(points[:, 2], kind="stable")
    dots = axes.scatter(
        *points[order, :2].T,
        s=1.2,
        c=points[order, 2],
        cmap=theme.HEIGHT_MAP,
        vmin=lowest,
        vmax=highest,
        linewidths=0,
        rasterized=True,
    )
    if np.ptp(points[:, 2]) > 0:  # not of a planar radar
        bar = figure.colorbar(
            dots, label="height z [m]", location="top", shrink=0.6, pad=0.02, aspect=36, anchor=(0, 0)
        )
        bar.outline.set_visible(False)
    axes.plot(*path.T, color=series_style(1)["color"], linewidth=1.6)
    axes.grid(visible=False)
    return figure


def height_limits(points):
    """Low and high end of the colours [m]; a level map gets the middle one."""
    low, high = np.percentile(points[:, 2], [5, 95])
    middle, half = (low + high) / 2, max((high - low) / 2, 0.5)
    return middle - half, middle + half


def thinned(points, most):
    """Evenly spread over the order of the points, at most `most` of them."""
    if len(points) <= most:
        return points
    return points[np.linspace(0, len(points) - 1, most).astype(int)]

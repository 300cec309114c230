# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and the way of a matplotlib figure into the page and into files.

A figure is drawn once, in the colours of the light page. In the page each colour becomes a CSS
variable, so that the same picture is readable on light and dark.
"""

import io
import re

import matplotlib

matplotlib.use("Agg")  # no display needed
import matplotlib.colors  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402

from report.output_folder import write_file  # noqa: E402

# (light, dark) of each role. Each light colour is unlike the others, for it stands for its role.
INK = ("#1c2127", "#e8eaed")
MUTED = ("#5b6470", "#a3abb5")
GRID = ("#dde1e6", "#343b45")
PANEL = ("#ffffff", "#181c22")
TRUTH = ("#8d949e", "#8b939e")
LIMIT = ("#b3261f", "#ff8a80")

# Told apart with any colour vision (after Okabe and Ito), and by their dashes.
SERIES = (
    ("#0067a8", "#58b4f0"),
    ("#c94f00", "#ff9a52"),
    ("#00795a", "#35cfa2"),
    ("#a3438a", "#eda0d3"),
    ("#8a6d00", "#f0cf4a"),
    ("#2f2f8f", "#a6a6ff"),
    ("#6b4a3a", "#d3ab97"),
    ("#3f7f1f", "#9fdc74"),
)
DASHES = ("-", (0, (6, 1.6)), (0, (3, 1.2)), (0, (6, 1.5, 1.5, 1.5)), (0, (1.4, 1.2)),
          (0, (9, 2)), (0, (5, 1.2, 1.2, 1.2, 1.2, 1.2)), (0, (2.2, 2.2)))  # fmt: skip

HEIGHT_MAP = matplotlib.colors.LinearSegmentedColormap.from_list(
    "height", [plt.get_cmap("viridis")(0.2 + 0.62 * i / 63) for i in range(64)]
)


def roles():
    """Name of the CSS variable to (light, dark)."""
    named = {"ink": INK, "muted": MUTED, "grid": GRID, "panel": PANEL}
    named |= {"truth": TRUTH, "limit": LIMIT}
    return named | {f"series-{i}": pair for i, pair in enumerate(SERIES)}


def css_variables(dark):
    return "".join(f"--{name}:{pair[dark]};" for name, pair in roles().items())


def series_style(index):
    """Colour and dashes of the index-th variant."""
    return {"color": SERIES[index % len(SERIES)][0], "linestyle": DASHES[index % len(DASHES)]}


def new_figure(width, height, **grid):
    """Figure and axes, in inches."""
    plt.rcParams.update(
        {
            "font.family": "DejaVu Sans",
            "font.size": 9,
            "axes.labelsize": 9,
            "legend.fontsize": 8.5,
            "legend.frameon": False,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.edgecolor": MUTED[0],
            "axes.labelcolor": INK[0],
            "axes.titlecolor": INK[0],
            "text.color": INK[0],
            "xtick.color": MUTED[0],
            "ytick.color": MUTED[0],
            "xtick.labelcolor": INK[0],
            "ytick.labelcolor": INK[0],
            "axes.facecolor": "none",
            "figure.facecolor": "none",
            "grid.color": GRID[0],
            "grid.linewidth": 0.7,
            "axes.grid": True,
            "axes.axisbelow": True,
            "lines.linewidth": 1.5,
            "svg.fonttype": "none",
            "pdf.fonttype": 42,
            "agg.path.chunksize": 20000,
        }
    )
    return plt.subplots(figsize=(width, height), layout="constrained", **grid)


def finish(figure, name, folder, dpi):
    """Writes folder/NAME.svg and .pdf, closes the figure and returns the SVG for the page.

    `dpi` is that of the parts that are pixels: clouds of points.
    """
    text = {}
    for form, metadata in (("svg", {"Date": None}), ("pdf", {"CreationDate": None})):
        with plt.rc_context({"svg.hashsalt": name}):
            buffer = io.BytesIO()
            figure.savefig(
                buffer,
                format=form,
                dpi=dpi,
                metadata=metadata,
                facecolor=PANEL[0] if form == "svg" else "none",
            )
        text[form] = buffer.getvalue()
        write_file(folder / f"{name}.{form}", text[form])
    plt.close(figure)
    return inline_svg(text["svg"].decode("utf-8"), name)


def inline_svg(svg, name):
    """The svg element alone, its colours as CSS variables, its ids its own on the page."""
    svg = svg[svg.index("<svg") :].strip()
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r'\bid="', f'id="{name}-', svg)
    svg = re.sub(r'xlink:href="#', f'xlink:href="#{name}-', svg)
    svg = svg.replace("url(#", f"url(#{name}-")
    for role, (light, _) in roles().items():
        svg = svg.replace(light, f"var(--{role})")
    size = re.search(r'<svg[^>]*? width="([\d.]+)pt" height="([\d.]+)pt"', svg)
    if size:
        svg = svg.replace(f'width="{size[1]}pt" height="{size[2]}pt"', 'width="100%"', 1)
    return svg

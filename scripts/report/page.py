# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The self-contained HTML page: no request leaves it, it works from a file."""

import html
import json
import pathlib
import re

from report import tables, theme, viewer

FOLDER = pathlib.Path(__file__).resolve().parent
POLICY = (
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
)
DARK = "--background:#101318;--canvas:#0c0f13;--accent:#58b4f0;"
NOTICE = "<!--\n3D view: three.js\n\n{}-->"


def anchor(text):
    return "sequence-" + re.sub(r"[^A-Za-z0-9]+", "-", text).strip("-").lower()


def build(content):
    """`content` is a Content (see content.py)."""
    parts = [
        "<!DOCTYPE html>",
        '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        f"<title>{html.escape(content.title)} · RaDiVe report</title>",
        f"<style>{style()}</style></head><body>",
        navigation(content),
        "<main>",
        header(content),
        '<h2 id="results">Results</h2>' if content.tables else "",
        '<div class="tables">',
        *[tables.to_html(table) for table in content.tables],
        "</div>",
        viewer_section(content.scenes),
        *[sequence_section(section) for section in content.sections],
        footer(content),
        "</main>",
        scripts(content.scenes),
        "</body></html>",
    ]
    return "\n".join(part for part in parts if part) + "\n"


def style():
    dark = DARK + theme.css_variables(dark=True) + "color-scheme:dark;"
    return "\n".join(
        [
            (FOLDER / "page.css").read_text(encoding="utf-8"),
            f":root{{{theme.css_variables(dark=False)}}}",
            f"@media (prefers-color-scheme: dark){{:root:not([data-theme=light]){{{dark}}}}}",
            f":root[data-theme=dark]{{{dark}}}",
            ":root[data-theme=light]{color-scheme:light;}",
        ]
    )


def navigation(content):
    links = ['<a class="name" href="#top">RaDiVe</a>']
    if content.tables:
        links.append('<a href="#results">Results</a>')
    if content.scenes:
        links.append('<a href="#viewer-title">3D view</a>')
    links += [
        f'<a href="#{anchor(section.name)}">{html.escape(section.name)}</a>'
        for section in content.sections[:30]
    ]
    button = '<button id="theme" type="button" aria-label="Change light and dark" hidden></button>'
    bar = "".join([*links, button])
    return f'<nav class="bar" id="top" aria-label="Sections"><div>{bar}</div></nav>'


def header(content):
    facts = "".join(
        f"<li><b>{html.escape(value)}</b><span>{html.escape(name)}</span></li>"
        for name, value in content.facts
    )
    lead = f'<p class="lead">{html.escape(content.lead)}</p>'
    title = html.escape(content.title)
    return f'<header><h1>{title}</h1>{lead}<ul class="facts">{facts}</ul></header>'


def viewer_section(scenes):
    if not scenes:
        return ""
    return """<h2 id="viewer-title">3D view</h2>
<figure class="card" id="viewer">
<div class="view"><canvas tabindex="0" role="img" aria-label="Trajectory and map points in 3D. Arrow
 keys move the view, plus and minus zoom; with the mouse drag to turn, right-drag to move, wheel to
 zoom."></canvas></div>
<div class="controls">
<select aria-label="Sequence and variant"></select>
<button type="button" data-action="play" aria-pressed="false">Play</button>
<input type="range" min="0" max="0" step="1" value="0" aria-label="Time along the drive">
</div>
<div class="controls">
<output></output>
<button type="button" data-view="oblique">Overview</button>
<button type="button" data-view="top">From above</button>
<button type="button" data-view="vehicle">At the vehicle</button>
<label><input type="checkbox" data-layer="follow"> follow</label>
<label><input type="checkbox" data-layer="map" checked> map</label>
<label><input type="checkbox" data-layer="truth" checked> ground truth</label>
</div>
<figcaption><span class="swatch" style="background:var(--series-1)"></span>estimate
&nbsp; <span class="swatch" style="background:var(--truth)"></span>ground truth.
Points are coloured by height; those the drive has come near up to the slider's time are bright.
</figcaption></figure>"""


def sequence_section(section):
    figures = "".join(
        f'<figure class="card"><h3>{html.escape(title)}</h3>{labelled(svg, title)}'
        f"<figcaption>{html.escape(caption)}</figcaption></figure>"
        for title, caption, svg in section.figures
    )
    note = f'<p class="muted">{html.escape(section.lead)}</p>' if section.lead else ""
    return (
        f'<section><h2 id="{anchor(section.name)}">{html.escape(section.name)}</h2>{note}'
        f'<div class="grid">{figures}</div></section>'
    )


def labelled(svg, title):
    """With a name for those who cannot see it."""
    return svg.replace("<svg ", f'<svg role="img" aria-label="{html.escape(title)}" ', 1)


def footer(content):
    notes = "".join(f"<p>{html.escape(note)}</p>" for note in content.notes)
    return f'<footer id="notes">{notes}</footer>'


def scripts(scenes):
    out = [f"<script>{(FOLDER / 'page.js').read_text(encoding='utf-8')}</script>"]
    if scenes:
        named = [{"name": scene_name(scene, scenes)} | scene for scene in scenes]
        # A "</script>" in a name must not end the element.
        data = json.dumps(named, separators=(",", ":")).replace("<", "\\u003c")
        out.append(NOTICE.format(viewer.licence()))
        out.append(f'<script id="viewer-data" type="application/json">{data}</script>')
        out.append(f"<script>{viewer.script()}</script>")
    return "\n".join(out)


def scene_name(scene, scenes):
    """Sequence, and variant where there are several."""
    several = len({other["variant"] for other in scenes}) > 1
    return f"{scene['sequence']} · {scene['variant']}" if several else scene["sequence"]

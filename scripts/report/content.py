# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the report shows: facts, tables, figures and scenes of a study, whatever the format."""

import dataclasses
import re

from report import figures, result_tables, surface_figures, theme, trajectories, viewer


@dataclasses.dataclass
class Section:
    name: str
    lead: str
    figures: list  # (title, caption, svg of the page)
    files: list  # (title, name of the file without its ending)


@dataclasses.dataclass
class Content:
    title: str
    lead: str
    facts: list  # (name, value)
    tables: list
    sections: list
    scenes: list
    notes: list


def build(study, folder):
    """Everything but the page. Writes the figures into `folder`."""
    typical = {
        (sequence, variant): study.typical_run(sequence, variant)
        for sequence in study.sequences
        for variant in study.variants
    }
    return Content(
        title=study.title,
        lead=lead(study),
        facts=facts(study),
        tables=result_tables.all_tables(study),
        sections=[section(study, sequence, typical, folder) for sequence in study.sequences],
        scenes=viewer.scenes(
            [(sequence, study.label(variant), run) for (sequence, variant), run in typical.items()]
        ),
        notes=notes(study, typical),
    )


def lead(study):
    if study.is_single:
        facts_of_run = study.runs[0].facts
        return facts_of_run.get("source", "A run of radive_odometry")
    counts = (
        (len(study.sequences), "sequence"),
        (len(study.variants), "variant"),
        (result_tables.seeds(study), "seed"),
    )
    return ", ".join(f"{n} {word}{'s' * (n != 1)}" for n, word in counts)


def facts(study):
    if study.is_single:
        return run_facts(study.runs[0])
    present = [run for run in study.runs if not run.is_absent]
    found = [("runs finished", f"{sum(run.is_ok for run in present)} of {len(present)}")]
    if len(present) < len(study.runs):
        found.append(("runs without their data", f"{len(study.runs) - len(present)}"))
    path = sum(run.metric("path_length") for run in study.runs if run.metric("path_length") > 0)
    if path:
        found.append(("driven in all", f"{path / 1000:.1f} km"))
    scans = sum(run.metric("scans") for run in study.runs if run.metric("scans") > 0)
    if scans:
        found.append(("scans in all", f"{scans:,.0f}"))
    return found


def run_facts(run):
    path = run.metric("path_length")
    found = [("scans", f"{len(run.estimate):,}"), ("path", f"{path:,.0f} m")]
    if run.errors:
        found.append(("ATE translation", f"{run.metric('ate_t'):.3f} m"))
        found.append(("ATE rotation", f"{run.metric('ate_r'):.3f}°"))
    if run.times:
        found.append(("time per scan, median", f"{run.scan_time('median'):.1f} ms"))
    if run.period_ms > 0:
        found.append(("between scans", f"{run.period_ms:.0f} ms"))
    if run.return_shares:
        found += return_facts(run.return_shares)
    return found


def return_facts(shares):
    """Which share of the returns registration works with, and why the others are left out."""
    left_out = [
        f"{100 * share:.1f} % {name.replace('_', ' ')}"
        for name, share in shares.items()
        if name != "kept" and share > 0
    ]
    found = [("returns used", f"{100 * shares['kept']:.1f} %")]
    return found + ([("returns left out", ", ".join(left_out))] if left_out else [])


def section(study, sequence, typical, folder):
    runs = [(i, study.label(v), typical[sequence, v]) for i, v in enumerate(study.variants)]
    drawn = [run for _, _, run in runs if run]
    if not drawn:
        states = sorted({run.status for run in study.of(sequence)})
        return Section(sequence, f"No run to draw: {', '.join(states)}.", [], [])
    result = Section(sequence, sequence_lead(drawn, study.period_ms(sequence)), [], [])
    stem = re.sub(r"[^A-Za-z0-9]+", "_", sequence).strip("_") or "sequence"
    stem = f"{study.sequences.index(sequence):02d}_{stem}"
    dpi = 170 if len(study.sequences) < 7 else 100
    for kind, title, caption, figure in pictures(study, sequence, runs, drawn):
        if figure is not None:
            svg = theme.finish(figure, f"{stem}_{kind}", folder, dpi)
            result.figures.append((title, caption, svg))
            result.files.append((title, f"{stem}_{kind}"))
    return result


def pictures(study, sequence, runs, drawn):
    """(kind, title, caption, figure) one by one; the figure is None where there are no data."""
    several = result_tables.seeds(study) > 1
    whose = "The seed of the median ATE_t of each variant. " if several else ""
    has_truth = any(run.errors for run in drawn)
    above = "Seen from above, aligned to the ground truth." if has_truth else "Seen from above."
    yield "trajectory", "Trajectory", whose + above, figures.trajectory_figure(runs)

    mapped = next((run for run in drawn if len(run.map_points)), None)
    variant = study.label(mapped.variant) if mapped else ""
    caption = f"Points of the keyframes of {variant}, with the estimated trajectory."
    yield "map", "Map", caption, figures.map_figure(mapped)

    caption = whose + "Absolute pose error."
    yield "errors", "Error over distance", caption, figures.error_figure(runs)

    all_errors = [
        (i, study.label(v), [r.errors for r in study.of(sequence, v) if r.is_ok and r.errors])
        for i, v in enumerate(study.variants)
    ]
    caption = "Median, quartiles, 5th and 95th percentile over all poses"
    caption += " of all seeds." if several else "."
    yield "ape", "Absolute pose error", caption, figures.ape_figure(all_errors)

    caption = (
        "The neural submap where it is densest, before and after the extraction of surface points; "
        "blue: the side that the radar saw."
    )
    extraction = figures_of(drawn, surface_figures.extraction_figure)
    yield "surface", "Surface points", caption, extraction

    caption = "Signed distance at one height; the line is its zero."
    yield "slice", "Slice of the field", caption, figures_of(drawn, surface_figures.slice_figure)

    caption = "Running median over 25 scans; the dotted line is the time between scans."
    period = study.period_ms(sequence)
    yield "time", "Time per scan", caption, figures.time_figure(runs, period)


def figures_of(runs, draw):
    """The figure of the first run that has one."""
    return next((figure for figure in map(draw, runs) if figure is not None), None)


def sequence_lead(drawn, period):
    run = drawn[0]
    path = trajectories.distance_travelled(run.estimate)[-1]
    parts = [f"{len(run.estimate):,} scans", f"{path:,.0f} m"]
    if period:
        parts.append(f"one scan in {period:.0f} ms")
    if all(run.errors is None for run in drawn):
        parts.append("no ground truth")
    return ", ".join(parts) + "."


def notes(study, typical):
    found = [
        "ATE: root mean square of the absolute pose error as evo has it; alignment "
        f"{study.align}, projection to the plane {study.plane}."
    ]
    versions = sorted({run.facts["version"] for run in filter(None, typical.values()) if run.facts})
    if versions:
        found.append("RaDiVe " + ", ".join(versions) + ".")
    if study.is_single and "command_line" in study.runs[0].facts:
        found.append("Command: " + study.runs[0].facts["command_line"])
    return found

# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of a study: errors, comparison with the first variant, spread, time, failures."""

import math
import statistics

import numpy as np

from report.run_files import number
from report.tables import ABSENT, FAILED, Cell, Table, decimals, ranked, rows_of_columns

SEQUENCES_A_TABLE = 4  # as in the paper: what fits a column of it
MOST_FAILURES = 100
PUBLISHED = "†"
RATIO_NOTES = [
    "Median ratio of paired runs and its 95 % interval.",
    "Bold: better, the interval clear of 1; underlined: worse, clear of 1.",
]
METRICS = (
    ("ate", "Absolute trajectory error", ("ate_t", "ate_r"), ("ATE_t", "ATE_r"), "m and degrees"),
    ("rpe", "Relative pose error", ("rpe_t", "rpe_r"), ("RPE_t", "RPE_r"), "m and degrees"),
    ("drift", "Drift of segments as in KITTI", ("drift_t", "drift_r"), ("drift_t", "drift_r"),
     "% and degrees a metre"),
)  # fmt: skip


def all_tables(study):
    tables = []
    for name, caption, metrics, heads, unit in METRICS:
        if any(not math.isnan(run.metric(metric)) for run in study.runs for metric in metrics):
            tables += metric_tables(study, name, f"{caption}, {unit}", metrics, heads)
            if name == "ate":
                tables += comparison_tables(study) + spread_tables(study)
    tables += time_tables(study)
    return [table for table in tables if has_content(table)] + failure_tables(study)


def has_content(table):
    return any(cell.text not in (FAILED, ABSENT, "") for _, row in table.rows for cell in row)


def split(study, name, caption, make):
    """make(sequences, name, caption) for chunks of at most SEQUENCES_A_TABLE, evenly filled."""
    count = math.ceil(len(study.sequences) / SEQUENCES_A_TABLE)
    chunks = [list(map(str, c)) for c in np.array_split(np.array(study.sequences, object), count)]
    if count == 1:
        return [make(chunks[0], name, caption)]
    return [
        make(chunk, f"{name}_{index}", f"{caption} ({index} of {count})")
        for index, chunk in enumerate(chunks, 1)
    ]


def labels(study, variants=None):
    return [study.label(variant) for variant in (study.variants if variants is None else variants)]


def published_methods(study, sequences, metrics):
    """Whose published figures stand beside those of the study, in the order of the file."""
    rows = [row for row in study.published if row["sequence"] in sequences]
    return list(dict.fromkeys(r["method"] for r in rows if any(r.get(m) for m in metrics)))


def published_column(study, sequence, metric, methods):
    """Values and texts."""
    values, texts = [], []
    for method in methods:
        rows = [r for r in study.published if (r["sequence"], r["method"]) == (sequence, method)]
        values.append(number(rows[0].get(metric)) if rows else math.nan)
        texts.append(decimals(values[-1], 2 if metric == "ms_per_scan" else 3) if rows else "")
    return values, texts


def names_with(published, names):
    return [f"{method} {PUBLISHED}" for method in published] + names


def metric_tables(study, name, caption, metrics, heads):
    def make(sequences, name, caption):
        published = published_methods(study, sequences, metrics)
        columns = [
            metric_column(study, sequence, metric, published)
            for sequence in sequences
            for metric in metrics
        ]
        names = names_with(published, labels(study))
        table = Table(
            name,
            caption,
            columns=list(heads) * len(sequences),
            groups=[(sequence, len(metrics)) for sequence in sequences],
            rows=rows_of_columns(names, columns),
        )
        table.notes = metric_notes(study, table)
        return table

    return split(study, name, caption, make)


def metric_column(study, sequence, metric, published):
    values, texts = published_column(study, sequence, metric, published)
    notes = [""] * len(values)
    for variant in study.variants:
        planned = study.of(sequence, variant)
        runs = [run for run in planned if not run.is_absent]
        found = study.values(sequence, variant, lambda run: run.metric(metric))
        is_measured = 2 * len(found) > len(runs)
        values.append(statistics.median(found) if is_measured else math.nan)
        texts.append(decimals(values[-1]) if runs else ABSENT if planned else "")
        notes.append(f"({len(found)}/{len(runs)})" if 0 < len(found) < len(runs) else "")
    return ranked(values, texts, notes)


def metric_notes(study, table):
    notes = []
    cells = [cell for _, row in table.rows for cell in row]
    if any(cell.rank for cell in cells):
        notes.append("Best in bold, second underlined.")
    if seeds(study) > 1:
        notes.append(f"Medians over up to {seeds(study)} seeds.")
    if any(cell.text == FAILED for cell in cells):
        notes.append(f"'{FAILED}': half of the runs or more failed." if seeds(study) > 1
                     else f"'{FAILED}': failed.")  # fmt: skip
    if any(cell.note for cell in cells):
        notes.append("(k/n): k of n runs succeeded.")
    if any(cell.text == ABSENT for cell in cells):
        notes.append(f"{ABSENT}: the data are not on this machine.")
    if any(name.endswith(PUBLISHED) for name, _ in table.rows):
        notes.append(f"{PUBLISHED}: as published, not run here.")
    return notes


def seeds(study):
    """Most runs of one sequence and variant."""
    return max(len(study.of(s, v)) for s in study.sequences for v in study.variants)


def summary_row(study, variant, sequence, metric):
    for row in study.summary:
        if (row["variant"], row["sequence"], row["metric"]) == (variant, sequence, metric):
            return row
    return None


def comparison_tables(study):
    """Ratios to the first variant with their intervals, as radive_batch has worked them out."""
    others = study.variants[1:]
    if not others or not any(row.get("ratio") for row in study.summary):
        return []

    def make(sequences, name, caption):
        columns = [
            [ratio_cell(summary_row(study, variant, sequence, metric)) for variant in others]
            for sequence in sequences
            for metric in ("ate_t", "ate_r")
        ]
        return Table(
            name,
            caption,
            columns=["ATE_t", "ATE_r"] * len(sequences),
            groups=[(sequence, 2) for sequence in sequences],
            rows=rows_of_columns(labels(study, others), columns),
            notes=RATIO_NOTES,
        )

    first = study.label(study.variants[0])
    overall = overall_comparison(study, f"Compared with {first}, all sequences", others)
    if len(study.sequences) == 1:
        return [overall]
    caption = f"Compared with {first}, each sequence"
    return [overall, *split(study, "comparison_each", caption, make)]


def overall_comparison(study, caption, others):
    columns = []
    for metric in ("ate_t", "ate_r"):
        rows = [summary_row(study, variant, "*", metric) for variant in others]
        columns.append([ratio_cell(row) for row in rows])
        columns.append([ratio_cell(row, "_drives") for row in rows])
    return Table(
        "comparison",
        caption,
        columns=["ATE_t", "on other drives", "ATE_r", "on other drives"],
        rows=rows_of_columns(labels(study, others), columns),
        notes=[*RATIO_NOTES, "On other drives: the interval with drives drawn at random, too."],
    )


def ratio_cell(row, drives=""):
    """The ratio with its interval or, for `drives`, that interval alone."""
    ratio = math.nan if row is None else number(row.get("ratio"))
    if math.isnan(ratio):
        return Cell(FAILED)
    low, high = (number(row.get(f"ratio_{end}{drives}")) for end in ("low", "high"))
    interval = "" if math.isnan(low) else f"[{decimals(low)}, {decimals(high)}]"
    rank = 1 if high < 1 else 2 if low > 1 else 0
    if drives:
        return Cell(interval or FAILED, rank)
    return Cell(decimals(ratio), rank, interval)


def spread_tables(study):
    """Median and quartiles over the seeds, of summary.csv."""
    if seeds(study) < 2 or not study.summary:
        return []

    def make(sequences, name, caption):
        columns = [
            [spread_cell(summary_row(study, v, sequence, metric)) for v in study.variants]
            for sequence in sequences
            for metric in ("ate_t", "ate_r")
        ]
        return Table(
            name,
            caption,
            columns=["ATE_t", "ATE_r"] * len(sequences),
            groups=[(sequence, 2) for sequence in sequences],
            rows=rows_of_columns(labels(study), columns),
        )

    return split(study, "spread", "Spread over the seeds: median (quartiles), m and degrees", make)


def spread_cell(row):
    if row is None or math.isnan(number(row["median"])):
        return Cell(FAILED)
    median, low, high = (number(row[name]) for name in ("median", "q25", "q75"))
    return Cell(decimals(median), note=f"({decimals(low)}–{decimals(high)})")


def time_tables(study):
    """Median and 95th percentile of the time of a scan, beside the sensor's period."""

    def make(sequences, name, caption):
        groups, columns = [], []
        published = published_methods(study, sequences, ("ms_per_scan",))
        for sequence in sequences:
            period = study.period_ms(sequence)
            groups.append((f"{sequence} ({period:.0f} ms)" if period else sequence, 2))
            for which in ("median", "p95"):
                columns.append(time_column(study, sequence, which, published))
        notes = ["In brackets the time between scans: the limit of real time."]
        if published:
            notes.append(f"{PUBLISHED}: as published (mean), on another machine.")
        return Table(
            name,
            caption,
            columns=["median", "95 %"] * len(sequences),
            groups=groups,
            rows=rows_of_columns(names_with(published, labels(study)), columns),
            notes=notes,
        )

    return split(study, "time", "Time per scan, ms", make)


def time_column(study, sequence, which, published):
    metric = "ms_per_scan" if which == "median" else ""
    values, texts = published_column(study, sequence, metric, published)
    texts = [text if metric else "" for text in texts]
    values = [math.nan] * len(values)  # no rank: another machine
    for variant in study.variants:
        times = study.values(sequence, variant, lambda run: run.scan_time(which))
        values.append(statistics.median(times) if times else math.nan)
        planned = study.of(sequence, variant)
        is_absent = all(run.is_absent for run in planned)
        text = ABSENT if planned else ""
        texts.append(text if is_absent else decimals(values[-1], 2))
    return ranked(values, texts)


def failure_tables(study):
    failed = [run for run in study.runs if not run.is_ok and not run.is_absent]
    if not failed:
        return []
    shown = failed[:MOST_FAILURES]
    rows = []
    for run in shown:
        texts = (study.label(run.variant), run.seed, run.status, run.message)
        rows.append((run.sequence, [Cell(text) for text in texts]))
    table = Table(
        "failures",
        f"Runs that did not finish: {len(failed)} of {len(study.runs)}",
        columns=["variant", "seed", "status", "message"],
        head="sequence",
        rows=rows,
    )
    if len(shown) < len(failed):
        table.notes = [f"The first {len(shown)} are listed."]
    return [table]

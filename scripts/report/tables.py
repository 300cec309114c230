# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables that know no output format: the same cells as HTML, Markdown and LaTeX.

As in the paper: the best of a column is bold, the second underlined, '-' stands for a failure.
"""

import dataclasses
import html
import math

FAILED = "-"
ABSENT = "n/a"


@dataclasses.dataclass(frozen=True)
class Cell:
    text: str
    rank: int = 0  # 1 best, 2 second, 0 neither
    note: str = ""  # small, behind the text


@dataclasses.dataclass
class Table:
    name: str  # of the label and the anchor
    caption: str
    columns: list  # names of the value columns
    groups: list = dataclasses.field(default_factory=list)  # (name, number of columns) above them
    rows: list = dataclasses.field(default_factory=list)  # (name, cells)
    head: str = ""  # above the names of the rows
    notes: list = dataclasses.field(default_factory=list)


def decimals(value, digits=3):
    """As the paper prints errors: three decimals."""
    return FAILED if value is None or not math.isfinite(value) else f"{value:.{digits}f}"


def ranked(values, texts, notes=None):
    """Cells of a column, where less is better. Equal texts share a rank."""
    printed = sorted({(float(t), t) for v, t in zip(values, texts) if math.isfinite(v)})
    best = [text for _, text in printed[:2]] if len(texts) > 1 else []
    notes = notes or [""] * len(texts)
    return [
        Cell(text, best.index(text) + 1 if text in best else 0, note)
        for text, note in zip(texts, notes)
    ]


def rows_of_columns(names, columns):
    return [(name, [column[i] for column in columns]) for i, name in enumerate(names)]


def to_html(table):
    out = [f'<figure class="table" id="table-{table.name}"><div class="scroll"><table>']
    out.append(f"<caption>{html.escape(table.caption)}</caption><thead>")
    if table.groups:
        cells = "".join(
            f'<th colspan="{count}" scope="colgroup">{html.escape(name)}</th>'
            for name, count in table.groups
        )
        out.append(f'<tr class="groups"><td></td>{cells}</tr>')
    cells = "".join(f'<th scope="col">{_html_name(name)}</th>' for name in table.columns)
    head = html.escape(table.head)
    out.append(f'<tr><th scope="col">{head}</th>{cells}</tr></thead><tbody>')
    for name, row in table.rows:
        cells = "".join(f"<td>{_html_cell(cell)}</td>" for cell in row)
        out.append(f'<tr><th scope="row">{html.escape(name)}</th>{cells}</tr>')
    out.append("</tbody></table></div>")
    if table.notes:
        notes = " ".join(html.escape(note) for note in table.notes)
        out.append(f"<figcaption>{notes}</figcaption>")
    return "\n".join([*out, "</figure>"])


def _html_name(name):
    base, _, index = name.partition("_")
    if len(index) != 1:
        return html.escape(name)
    return f"{html.escape(base)}<sub>{html.escape(index)}</sub>"


def _html_cell(cell):
    text = html.escape(cell.text)
    if cell.rank == 1:
        text = f"<strong>{text}</strong>"
    elif cell.rank == 2:
        text = f"<u>{text}</u>"
    return text + (f" <small>{html.escape(cell.note)}</small>" if cell.note else "")


def to_markdown(table):
    """A pipe table. Its one row of heads holds the group's name with the column's."""
    heads = list(table.columns)
    if table.groups:
        names = [name for name, count in table.groups for _ in range(count)]
        heads = [f"{group} {column}" for group, column in zip(names, heads)]
    lines = [f"**{_markdown_text(table.caption)}**", ""]
    lines.append("| " + " | ".join([table.head, *map(_markdown_text, heads)]) + " |")
    lines.append("| --- |" + " ---: |" * len(heads))
    for name, row in table.rows:
        cells = [_markdown_cell(cell) for cell in row]
        lines.append("| " + " | ".join([_markdown_text(name), *cells]) + " |")
    if table.notes:
        lines += ["", _markdown_text(" ".join(table.notes))]
    return "\n".join([*lines, ""])


def _markdown_text(text):
    for character in "\\|_*`<":
        text = text.replace(character, "\\" + character)
    return text


def _markdown_cell(cell):
    text = _markdown_text(cell.text)
    if cell.rank == 1:
        text = f"**{text}**"
    elif cell.rank == 2:
        text = f"<u>{text}</u>"
    return text + (f" {_markdown_text(cell.note)}" if cell.note else "")


LATEX_SPECIAL = {
    "\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_",
    "{": r"\{", "}": r"\}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "–": "--", "±": r"$\pm$", "×": r"$\times$", "°": r"$^\circ$", "−": "$-$",
    "…": r"\ldots{}", "†": r"$^\dagger$", "≥": r"$\geq$", "≤": r"$\leq$",
}  # fmt: skip


def latex_text(text):
    return "".join(LATEX_SPECIAL.get(character, character) for character in text)


def to_latex(table):
    """A table as in the paper; needs booktabs and graphicx (resizebox)."""
    groups = table.groups or [("", len(table.columns))]
    columns = "c|" + "|".join("c" * count for _, count in groups)
    out = [r"\begin{table}[t]", r"\centering", rf"\caption{{{latex_text(table.caption)}}}"]
    out.append(rf"\label{{tab:{table.name}}}")
    out += [r"\resizebox{\columnwidth}{!}{", rf"\begin{{tabular}}{{{columns}}}", r"\toprule"]
    if table.groups:
        heads = []
        for index, (name, count) in enumerate(groups):
            bar = "|" if index + 1 < len(groups) else ""
            heads.append(rf"\multicolumn{{{count}}}{{c{bar}}}{{\texttt{{{latex_text(name)}}}}}")
        out.append(" & " + " & ".join(heads) + r" \\")
    names = " & ".join(_latex_name(name) for name in table.columns)
    out.append(f"{latex_text(table.head)} & {names}" + r" \\ \midrule")
    for name, row in table.rows:
        cells = " & ".join(_latex_cell(cell) for cell in row)
        out.append(rf"\textbf{{{latex_text(name)}}} & {cells}" + r" \\")
    out += [r"\bottomrule", r"\end{tabular}}"]
    out += [rf"\par\footnotesize {latex_text(note)}" for note in table.notes]
    return "\n".join([*out, r"\end{table}", ""])


def _latex_name(name):
    base, _, index = name.partition("_")
    return f"{latex_text(base)}$_{index}$" if len(index) == 1 else latex_text(name)


def _latex_cell(cell):
    text = latex_text(cell.text)
    if cell.rank == 1:
        text = rf"\textbf{{{text}}}"
    elif cell.rank == 2:
        text = rf"\underline{{{text}}}"
    return text + (rf" {{\scriptsize {latex_text(cell.note)}}}" if cell.note else "")

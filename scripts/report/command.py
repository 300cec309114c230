# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of radive_report."""

import argparse
import pathlib
import re
import sys

from report import content, output_folder, page, tables
from report.run_files import FileError
from report.study import read_study, split_name
from report.trajectories import ALIGNMENTS, PLANES

OWN_FILES = ("report.html", "report.md", "tables.tex", "figures")
DESCRIPTION = """\
Writes the report of a study or of a run: one self-contained HTML page, the same as Markdown, the
tables as LaTeX, and the figures as SVG and PDF.

  radive_report STUDY                          STUDY is the output folder of radive_batch
  radive_report RUN --reference GROUND_TRUTH   RUN is a results folder of radive_odometry
  radive_report A=RUN B=RUN --output REPORT    several, with names; a file reference.tum in a RUN
                                               is its ground truth

Errors are those of radive_evaluate. Of a single run --align and --plane say which, of a study its
study.json; the default of both is that of radive_batch: se3, xy.

The output folder, by default report/ in the given one, gets
  report.html  report.md  tables.tex  figures/
The same input gives the same bytes.
"""


def version():
    """The version of the project: that of the source tree, or what the installation has noted."""
    package = pathlib.Path(__file__).resolve().parent
    noted = package.parent / "VERSION"
    if noted.is_file():
        return noted.read_text(encoding="utf-8").strip()
    cmake = (package.parent.parent / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(radive VERSION (\S+)", cmake, re.MULTILINE).group(1)


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="radive_report",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "folder", nargs="+", help="output of radive_batch or radive_odometry, [NAME=]FOLDER"
    )
    parser.add_argument("--reference", type=pathlib.Path, help="true trajectory of the run, TUM")
    parser.add_argument("--align", default="se3", choices=sorted(ALIGNMENTS), help="of runs")
    parser.add_argument("--plane", default="xy", choices=sorted(PLANES), help="of runs")
    parser.add_argument("--output", type=pathlib.Path, help="folder for the report")
    parser.add_argument("--title", help="instead of the folder's name")
    parser.add_argument("--version", action="version", version=f"radive_report {version()}")
    return parser.parse_args(arguments)


def markdown(found):
    lines = [f"# {found.title}", "", found.lead, ""]
    lines += [f"- {name}: {value}" for name, value in found.facts] + [""]
    lines += [tables.to_markdown(table) for table in found.tables]
    for section in found.sections:
        lines += [f"## {section.name}", "", section.lead, ""]
        lines += [f"![{title}](figures/{name}.svg)" for title, name in section.files] + [""]
    return "\n".join([*lines, *found.notes]) + "\n"


def latex(found):
    head = "% Needs \\usepackage{booktabs,graphicx}.\n\n"
    return head + "\n".join(tables.to_latex(table) for table in found.tables)


def run(arguments):
    if len(arguments.folder) > 1 and not arguments.output:
        raise FileError("the report of several runs needs --output")
    study = read_study(arguments.folder, arguments.reference, arguments.align, arguments.plane)
    study.title = arguments.title or study.title
    output = arguments.output or split_name(arguments.folder[0])[1] / "report"
    with output_folder.replaced(output, OWN_FILES) as folder:
        pictures = folder / "figures"
        pictures.mkdir()
        found = content.build(study, pictures)
        output_folder.write_file(folder / "report.md", markdown(found))
        output_folder.write_file(folder / "tables.tex", latex(found))
        output_folder.write_file(folder / "report.html", page.build(found))
    try:
        print(output / "report.html", flush=True)
    except OSError as error:
        raise FileError(f"standard output: cannot be written: {error.strerror}") from error


def main(arguments=None):
    try:
        run(parse(arguments))
    except (FileError, OSError) as error:
        print(f"radive_report: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0

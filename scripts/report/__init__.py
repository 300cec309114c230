# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The report that scripts/radive_report writes: results folder in, one page and tables out.

run_files  reads what a run wrote       trajectories     poses, alignment, errors
run        a run and its files          study            the runs of a study as one table
tables     HTML, Markdown and LaTeX     result_tables    which tables there are
theme      colours, light and dark      figures, surface_figures   pictures
viewer     data of the 3D view          content          everything, whatever the format
page       the HTML page                command          the command line
"""

# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The report that scripts/radive_report writes: results folder in, one page and tables out.

run_files   reads what a run wrote           trajectories  poses, alignment, errors
study       the runs of a study as one table  tables        HTML, Markdown and LaTeX
figures     matplotlib pictures               viewer        data of the interactive 3D view
page        puts the page together            command       the command line
"""

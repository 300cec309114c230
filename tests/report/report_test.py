# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The report without a browser: readers, errors, tables, files."""

import contextlib
import io
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import made_study
import numpy as np
from made_study import circle, write_run, write_study, write_tum, yaw_quaternion

from report import (
    command, result_tables, run_files, study, surface_figures, tables, trajectories, viewer,
)  # fmt: skip


class ScratchTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)


class RunFilesTest(ScratchTest):
    def test_tum_errors_name_the_line(self):
        path = self.scratch / "t.txt"
        path.write_text("# a comment\n1 0 0 0 0 0 0 2\n\n2 0 0 0 0 0 1\n")
        with self.assertRaisesRegex(run_files.FileError, r"t\.txt:4: expected 8 numbers"):
            run_files.read_tum(path)
        path.write_text("1 0 0 0 0 0 0 2 # quaternions are normalised\n")
        np.testing.assert_array_equal(run_files.read_tum(path), [[1, 0, 0, 0, 0, 0, 0, 1]])

    def test_ply_binary_and_ascii(self):
        path = self.scratch / "m.ply"
        made_study.write_ply(path, [[1, -2, 0.5], [math.nan, 0, 0]])
        np.testing.assert_array_equal(run_files.read_points(path), [[1, -2, 0.5]])
        path.write_text(
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty double y\n"
            "property float z\nproperty float sdf\nend_header\n1 2 3 0.5\n4 5 6 0.25\n"
        )
        np.testing.assert_array_equal(run_files.read_points(path), [[1, 2, 3], [4, 5, 6]])
        np.testing.assert_array_equal(run_files.read_ply(path)["sdf"], [0.5, 0.25])
        path.write_bytes(path.read_bytes()[:-12])
        with self.assertRaisesRegex(run_files.FileError, r"m\.ply: "):
            run_files.read_points(path)

    def test_csv_errors_name_column_and_line(self):
        path = self.scratch / "r.csv"
        path.write_text("a,b\n1,2\n3\n")
        with self.assertRaisesRegex(run_files.FileError, "no column c"):
            run_files.read_csv(path, ("a", "c"))
        with self.assertRaisesRegex(run_files.FileError, r"r\.csv:3: expected 2 fields"):
            run_files.read_csv(path)


class TrajectoriesTest(ScratchTest):
    def test_a_moved_and_turned_copy_has_no_error(self):
        truth = circle(lift=2.0)
        moved = truth.copy()
        turn = trajectories.rotation_matrices(yaw_quaternion([1.0]))[0]
        moved[:, 1:4] = truth[:, 1:4] @ turn.T + [5, -3, 1]
        moved[:, 4:] = yaw_quaternion(2 * np.arctan2(truth[:, 6], truth[:, 7]) + 1.0)
        for align in ("se3", "origin"):
            errors = trajectories.PoseErrors(truth, moved, align, "none")
            self.assertLess(errors.translation.max(), 1e-9, align)
            self.assertLess(errors.rotation.max(), 1e-7, align)
        unaligned = trajectories.PoseErrors(truth, moved, "none", "none")
        # The first pose is at (0, 0, 2) and went to (5, -3, 3).
        self.assertAlmostEqual(unaligned.translation[0], math.sqrt(25 + 9 + 1))
        self.assertAlmostEqual(unaligned.rotation[0], 1.0)

    def test_the_plane_leaves_height_and_roll_out(self):
        truth = circle()
        tilted = truth.copy()
        tilted[:, 3] += 4.0
        tilted[:, 4:] = [math.sin(0.2), 0, 0, math.cos(0.2)]  # roll of 0.4, yaw and pitch of 0
        truth[:, 4:] = yaw_quaternion(np.full(len(truth), 0.1))
        errors = trajectories.PoseErrors(truth, tilted, "none", "xy")
        np.testing.assert_allclose(errors.translation, 0, atol=1e-12)
        np.testing.assert_allclose(errors.rotation, 0.1)
        errors = trajectories.PoseErrors(truth, tilted, "none", "yz")
        np.testing.assert_allclose(errors.translation, 4.0)
        np.testing.assert_allclose(errors.rotation, 0.4)

    def test_only_poses_of_the_same_time_are_compared(self):
        truth = circle()
        late = truth[10:20].copy()
        late[:, 0] += 0.004
        late[3, 0] += 0.04
        errors = trajectories.PoseErrors(truth, late, "none", "none")
        self.assertEqual(len(errors.stamps), 9)
        with self.assertRaisesRegex(ValueError, "fewer than 3"):
            trajectories.PoseErrors(truth, late[:2])

    @unittest.skipUnless("RADIVE_EVALUATE" in os.environ, "RADIVE_EVALUATE is not set")
    def test_errors_are_those_of_radive_evaluate(self):
        truth, estimate = circle(), made_study.noisy(circle(), 0.3, 5)
        write_tum(self.scratch / "truth", truth)
        write_tum(self.scratch / "estimate", estimate)
        for align, plane in (("se3", "xy"), ("se3", "none"), ("origin", "xz")):
            ours = trajectories.PoseErrors(truth, estimate, align, plane).rmse()
            for relation, value in (("trans_part", ours[0]), ("angle_rad", ours[1])):
                output = subprocess.run(
                    [
                        os.environ["RADIVE_EVALUATE"], f"--reference={self.scratch}/truth",
                        f"--estimate={self.scratch}/estimate", f"--align={align}",
                        f"--plane={plane}", f"--relation={relation}", "--json",
                    ],
                    check=True, capture_output=True,
                ).stdout  # fmt: skip
                found = json.loads(output)
                self.assertAlmostEqual(found["rmse"], value, places=7, msg=f"{align} {plane}")


class TablesTest(unittest.TestCase):
    def test_ranks_by_what_is_printed(self):
        values = [2.0, 1.0004, math.nan, 1.0, 3.0]
        cells = tables.ranked(values, [tables.decimals(v) for v in values])
        self.assertEqual([c.text for c in cells], ["2.000", "1.000", "-", "1.000", "3.000"])
        self.assertEqual([c.rank for c in cells], [2, 1, 0, 1, 0])
        self.assertEqual(tables.ranked([1.0], ["1.000"])[0].rank, 0)  # no contest

    def test_formats(self):
        table = tables.Table(
            "ate_1",
            "Errors of a_b, 5 %",
            columns=["ATE_t", "95 %"],
            groups=[("loop_2", 2)],
            rows=[("Full|NDT & co", [tables.Cell("1.0", 1), tables.Cell("2.0", 2, "(1/2)")])],
        )
        markdown = tables.to_markdown(table).splitlines()
        self.assertEqual(markdown[2], "|  | loop\\_2 ATE\\_t | loop\\_2 95 % |")
        self.assertEqual(markdown[4], "| Full\\|NDT & co | **1.0** | <u>2.0</u> (1/2) |")
        latex = tables.to_latex(table)
        self.assertIn(r"\multicolumn{2}{c}{\texttt{loop\_2}} \\", latex)
        self.assertIn(r" & ATE$_t$ & 95 \% \\ \midrule", latex)
        cells = r"\textbf{1.0} & \underline{2.0} {\scriptsize (1/2)} \\"
        self.assertIn(r"\textbf{Full|NDT \& co} & " + cells, latex)
        page = tables.to_html(table)
        self.assertIn("<td><strong>1.0</strong></td><td><u>2.0</u> <small>(1/2)</small></td>", page)
        self.assertIn("Full|NDT &amp; co", page)


class StudyTest(ScratchTest):
    def setUp(self):
        super().setUp()
        self.study = study.read_study([write_study(self.scratch)])

    def cells(self, name):
        table = next(t for t in result_tables.all_tables(self.study) if t.name == name)
        return {row: [(c.text, c.rank, c.note) for c in cells] for row, cells in table.rows}

    def test_order_and_labels_are_those_of_the_plan(self):
        self.assertEqual(self.study.sequences, ["loop", "far"])
        self.assertEqual(self.study.variants, ["base", "ours", "lost"])
        self.assertEqual(self.study.label("base"), "The base")
        self.assertEqual(self.study.label("ours"), "ours")

    def test_error_table(self):
        # base 2 and 3, ours 1 and 2; the paper's 1.2 lies between the medians 2.5 and 1.5.
        cells = self.cells("ate")
        absent, failed = ("n/a", 0, ""), ("-", 0, "")
        self.assertEqual(cells["Paper †"], [("1.200", 1, ""), ("30.000", 0, ""), failed, failed])
        self.assertEqual(cells["The base"], [("2.500", 0, ""), ("20.000", 2, ""), absent, absent])
        self.assertEqual(cells["ours"], [("1.500", 2, ""), ("10.000", 1, ""), absent, absent])
        self.assertEqual(cells["lost"], [("-", 0, ""), ("-", 0, ""), absent, absent])

    def test_variants_of_some_sequences_and_published_times(self):
        runs = [
            study.Run("a", "v", "0", row={"ate_t": "1"}, timing={"ms_per_scan_median": "5"}),
            study.Run("b", "w", "0", row={"ate_t": "2"}, timing={"ms_per_scan_median": "6"}),
        ]
        published = [{"sequence": "b", "method": "M", "ms_per_scan": "4.5"}]
        part = study.Study("", runs, ["a", "b"], ["v", "w"], published=published)
        errors = result_tables.metric_tables(part, "ate", "", ("ate_t",), ("ATE_t",))[0]
        times = result_tables.time_tables(part)[0]
        texts = [[(row, [c.text for c in cells]) for row, cells in t.rows] for t in (errors, times)]
        self.assertEqual(texts[0], [("v", ["1.000", ""]), ("w", ["", "2.000"])])
        expected = [("M †", ["", "", "4.50", ""]), ("v", ["5.00", "-", "", ""])]
        self.assertEqual(texts[1], [*expected, ("w", ["", "", "6.00", "-"])])

    def test_half_of_the_runs_failed_is_a_failure(self):
        for lost, expected in ((1, ("1.500", "(2/3)")), (2, ("-", "(2/4)"))):
            runs = self.study.of("loop", "ours")
            runs += [study.Run("loop", "ours", str(i), "timeout") for i in range(2, 2 + lost)]
            one = study.Study("", runs, ["loop"], ["ours"])
            table = result_tables.metric_tables(one, "x", "", ("ate_t",), ("ATE_t",))[0]
            cell = table.rows[0][1][0]
            self.assertEqual((cell.text, cell.note), expected)

    def test_comparison_marks_intervals_clear_of_one(self):
        cells = self.cells("comparison")
        better, worse = ("0.550", 1, "[0.500, 0.660]"), ("1.500", 2, "[1.100, 1.900]")
        self.assertEqual(cells["ours"], [better, ("[0.400, 1.200]", 0, ""), worse, ("-", 0, "")])
        self.assertEqual(cells["lost"], [("-", 0, "")] * 4)

    def test_failures_are_listed_absent_data_are_not(self):
        messages = [row[3][0] for row in self.cells("failures").values()]
        self.assertEqual(messages, ["signal 11, a | b_c"])

    def test_typical_run_is_the_lower_median(self):
        self.assertEqual(self.study.typical_run("loop", "base").seed, "0")
        self.assertIsNone(self.study.typical_run("loop", "lost"))
        self.assertAlmostEqual(self.study.period_ms("loop"), 100.0, places=6)

    def test_many_sequences_make_several_tables(self):
        runs = [study.Run(f"s{i}", "v", "0", row={"ate_t": "1"}) for i in range(9)]
        many = study.Study("", runs, [run.sequence for run in runs], ["v"])
        found = result_tables.metric_tables(many, "ate", "Errors", ("ate_t",), ("ATE_t",))
        self.assertEqual([len(table.columns) for table in found], [3, 3, 3])
        self.assertEqual(found[1].caption, "Errors (2 of 3)")


class SurfaceFiguresTest(unittest.TestCase):
    def test_spacing_of_a_turned_grid(self):
        y, x = np.mgrid[0:12, 0:10] * 0.25
        grid = np.stack([x, y], -1).reshape(-1, 2)
        turn = np.array([[math.cos(0.3), -math.sin(0.3)], [math.sin(0.3), math.cos(0.3)]])
        for vertices in (grid, grid @ turn.T):
            self.assertAlmostEqual(surface_figures.grid_spacing(vertices), 0.25, places=9)


class ViewerTest(unittest.TestCase):
    def test_points_show_once_the_drive_is_near(self):
        positions = np.array([[x, 0, 0] for x in range(0, 200, 10)], float)
        points = np.array([[150, 60, 0], [100, 0, 0], [0, 0, 5]], float)
        ordered, shown = viewer.revealed(points, positions)
        # The third at once, the second from x = 60 (40 m away), the first at its nearest, x = 150.
        np.testing.assert_array_equal(ordered, points[::-1])
        np.testing.assert_array_equal(shown[[0, 5, 6, 14, 15, 19]], [1, 1, 2, 2, 3, 3])


class CommandTest(ScratchTest):
    def test_version_is_that_of_the_project(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        found = subprocess.run(
            [root / "scripts/radive_report", "--version"], capture_output=True, text=True
        )
        citation = (root / "CITATION.cff").read_text(encoding="utf-8")
        version = next(line for line in citation.splitlines() if line.startswith("version: "))
        self.assertEqual(found.stdout, f"radive_report {version.split()[1]}\n")
        self.assertEqual(found.returncode, 0)

    def run_command(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = command.main(list(map(str, arguments)))
        return status, out.getvalue(), err.getvalue()

    def test_same_folder_same_bytes_and_every_file(self):
        write_study(self.scratch / "study")
        contents = []
        for name in ("a", "b"):
            output = self.scratch / name
            status, _, error = self.run_command(self.scratch / "study", "--output", output)
            self.assertEqual((status, error), (0, ""))
            files = sorted(p for p in output.rglob("*") if p.is_file())
            contents.append({str(p.relative_to(output)): p.read_bytes() for p in files})
        self.assertEqual(contents[0], contents[1])
        kinds = ("ape", "errors", "map", "time", "trajectory")
        figures = {f"figures/00_loop_{k}.{form}" for k in kinds for form in ("pdf", "svg")}
        self.assertEqual(set(contents[0]), figures | {"report.html", "report.md", "tables.tex"})
        page = contents[0]["report.html"].decode()
        self.assertNotRegex(page, r"""(?:src|href)=["'](?:https?:)?//""")
        self.assertIn("n/a", page)

    def test_a_study_of_which_nothing_finished(self):
        row = ["drive", "v", "0", "crashed", "</script><b>signal 11", *[""] * 12]
        made_study.write_csv(self.scratch / "results.csv", made_study.HEADER, [row])
        status, _, error = self.run_command(self.scratch)
        self.assertEqual((status, error), (0, ""))
        text = (self.scratch / "report" / "report.md").read_text()
        self.assertIn("- runs finished: 0 of 1", text)
        self.assertIn("No run to draw: crashed.", text)
        page = (self.scratch / "report" / "report.html").read_text()
        self.assertIn("&lt;/script&gt;&lt;b&gt;signal 11", page)
        self.assertNotIn("viewer-data", page)

    def test_a_run_without_ground_truth_and_map(self):
        write_run(self.scratch / "run", circle())
        (self.scratch / "run" / "map.ply").unlink()
        (self.scratch / "run" / "timing.csv").unlink()
        self.assertEqual(self.run_command(self.scratch / "run")[::2], (0, ""))
        text = (self.scratch / "run" / "report" / "report.md").read_text()
        self.assertIn("no ground truth", text)
        self.assertEqual(text.count("!["), 1, "the trajectory alone")

    def test_single_run_with_a_reference(self):
        truth = circle()
        estimate = truth.copy()
        estimate[:, 1:4] *= 1.1  # a circle 10 % too large: 2 m everywhere
        write_run(self.scratch / "run", estimate)
        (self.scratch / "run" / "scans.csv").write_text(
            "index,returns,kept,out_of_range,moving,occluded\n0,10,7,1,2,0\n1,30,25,0,5,0\n"
        )
        write_tum(self.scratch / "truth.txt", truth)
        status, out, _ = self.run_command(
            self.scratch / "run", "--reference", self.scratch / "truth.txt"
        )
        self.assertEqual((status, out), (0, f"{self.scratch / 'run' / 'report' / 'report.html'}\n"))
        text = (self.scratch / "run" / "report" / "report.md").read_text()
        # The last pose stands on the first, which draws the centre by 1/60 of a radius.
        self.assertRegex(text, r"- ATE translation: 1\.99\d m|- ATE translation: 2\.00\d m")
        self.assertIn("- scans: 60", text)
        self.assertIn("- returns used: 80.0 %", text)
        self.assertIn("- returns left out: 2.5 % out of range, 17.5 % moving", text)

    def test_several_runs_with_names(self):
        for name, scale in (("a", 1.1), ("b", 1.05)):
            estimate = circle()
            estimate[:, 1:4] *= scale
            write_run(self.scratch / name / "results", estimate, circle())
        runs = [f"{name}={self.scratch / name / 'results'}" for name in "ab"]
        status, _, error = self.run_command(*runs)
        self.assertEqual(status, 1)
        self.assertEqual(error, "radive_report: the report of several runs needs --output\n")
        status, _, _ = self.run_command(*runs, "--output", self.scratch / "report")
        self.assertEqual(status, 0)
        text = (self.scratch / "report" / "report.md").read_text()
        self.assertIn("| a ATE\\_t | a ATE\\_r | b ATE\\_t | b ATE\\_r |", text)
        self.assertRegex(text, r"\| RaDiVe \| (1\.99|2\.00)\d \| 0\.\d+ \| (0\.99|1\.00)\d \|")

    def test_pictures_of_the_neural_submap(self):
        write_run(self.scratch / "run", circle())
        made_study.write_surface(self.scratch / "run")
        status, _, error = self.run_command(self.scratch / "run")
        self.assertEqual((status, error), (0, ""))
        figures = self.scratch / "run" / "report" / "figures"
        surface = (figures / "00_run_surface.svg").read_text()
        self.assertIn("before extraction: 500", surface)
        self.assertIn("after extraction: 4", surface)  # about 50 of 500
        self.assertTrue((figures / "00_run_slice.pdf").is_file())

    def test_errors_are_a_sentence(self):
        status, _, error = self.run_command(self.scratch)
        self.assertEqual(status, 1)
        self.assertIn("neither results.csv (of radive_batch) nor trajectory_tum.txt", error)
        (self.scratch / "results.csv").write_text("sequence,variant\n")
        status, _, error = self.run_command(self.scratch)
        self.assertEqual(status, 1)
        self.assertIn("results.csv:1: no column seed, status", error)
        status, _, error = self.run_command(self.scratch / "nothing")
        self.assertIn("no such folder", error)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page in headless Chromium: nothing in the console, no request, the slider moves the view.

With --keep FOLDER the screenshots stay there, to be looked at.
"""

import pathlib
import sys
import tempfile
import unittest

import browser
from made_study import write_study

from report import command

KEEP = None


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        write_study(cls.scratch / "study")
        if command.main([str(cls.scratch / "study")]):
            raise RuntimeError("radive_report failed")
        cls.page = cls.scratch / "study" / "report" / "report.html"
        cls.browser = browser.Browser(cls.scratch / "profile")
        cls.addClassCleanup(cls.browser.__exit__)

    def setUp(self):
        self.browser.problems.clear()
        self.browser.requests.clear()
        self.browser.resize(1280, 900)
        self.browser.emulate_scheme("light")
        self.browser.open(self.page.as_uri())

    def tearDown(self):
        self.assertEqual(self.browser.problems, [])
        foreign = [url for url in self.browser.requests if not url.startswith("data:")]
        self.assertEqual(foreign, [self.page.as_uri()])

    def screenshot(self, name, whole_page=False):
        path = KEEP / f"{name}.png" if KEEP else None
        return self.browser.screenshot(path, whole_page)

    def state(self):
        return self.browser.evaluate("radiveViewer.state()")

    def test_the_slider_moves_the_view_by_keyboard(self):
        self.assertEqual(self.state()["pose"], 59)
        self.browser.evaluate("document.querySelector('#viewer input[type=range]').focus()")
        self.browser.evaluate("document.activeElement.scrollIntoView({block: 'end'})")
        self.browser.press("Home")
        first, before = self.state(), self.screenshot("start")
        self.assertEqual(first["pose"], 0)
        self.browser.press("ArrowRight", 15)
        second, after = self.state(), self.screenshot("quarter")
        self.assertEqual(second["pose"], 15)
        # A quarter of the way round the circle of 20 m, give or take the noise.
        self.assertAlmostEqual(second["vehicle"][0], 20, delta=1.5)
        self.assertAlmostEqual(second["vehicle"][1], 20, delta=1.5)
        self.assertGreater(second["points"], first["points"])
        self.assertGreater(second["drawn"], first["drawn"])
        self.assertNotEqual(before, after)
        readout = self.browser.evaluate("document.querySelector('#viewer output').textContent")
        self.assertRegex(readout, r"^1\.5 s · \d+ m · [\d.]+ m/s · position error [\d.]+ m$")

    def test_views_layers_and_runs(self):
        cameras = []
        for view in ("top", "vehicle", "oblique"):
            self.browser.click(f"[data-view={view}]")
            cameras.append(self.state()["camera"])
            self.screenshot(view)
        self.assertEqual(len({tuple(camera) for camera in cameras}), 3)
        drawn = self.state()["drawn"]
        self.browser.click("[data-layer=map]")
        self.screenshot("without_map")
        self.assertGreater(self.state()["drawn"], drawn)
        names = "[...document.querySelectorAll('#viewer option')].map(o => o.textContent)"
        self.assertEqual(self.browser.evaluate(names), ["loop · The base", "loop · ours"])
        self.browser.evaluate(
            "(s => {s.value = 1; s.dispatchEvent(new Event('change'))})"
            "(document.querySelector('#viewer select'))"
        )
        self.assertEqual(self.state()["pose"], 59)

    def test_follow_keeps_the_vehicle_in_the_middle(self):
        self.browser.click("[data-layer=follow]")
        self.browser.evaluate("document.querySelector('#viewer input[type=range]').focus()")
        self.browser.press("Home")
        first = self.state()
        self.browser.press("ArrowRight", 10)
        second = self.state()
        for axis in range(3):
            moved = second["vehicle"][axis] - first["vehicle"][axis]
            self.assertAlmostEqual(second["camera"][axis] - first["camera"][axis], moved, places=3)

    def test_light_dark_and_small_screens(self):
        background = "getComputedStyle(document.body).backgroundColor"
        light = self.browser.evaluate(background)
        self.screenshot("light", whole_page=True)
        self.browser.emulate_scheme("dark")
        dark = self.browser.evaluate(background)
        self.screenshot("dark", whole_page=True)
        self.assertNotEqual(light, dark)
        self.browser.click("#theme")
        self.assertEqual(self.browser.evaluate(background), light)
        self.browser.resize(390, 800)
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        self.screenshot("small", whole_page=True)

    def test_figures_follow_the_theme(self):
        label = "getComputedStyle(document.querySelector('section svg text')).fill"
        light = self.browser.evaluate(label)
        self.browser.emulate_scheme("dark")
        self.assertEqual(light, "rgb(28, 33, 39)")
        self.assertEqual(self.browser.evaluate(label), "rgb(232, 234, 237)")


if __name__ == "__main__":
    if "--keep" in sys.argv:
        at = sys.argv.index("--keep")
        KEEP = pathlib.Path(sys.argv[at + 1])
        KEEP.mkdir(parents=True, exist_ok=True)
        del sys.argv[at : at + 2]
    if browser.find() is None:
        print("SKIPPED: Chromium is not installed (apt-get install chromium)")
        sys.exit(0)
    unittest.main()

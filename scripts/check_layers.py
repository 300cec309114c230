#!/usr/bin/python3
"""Checks the layers of radive/: a folder includes only from itself and from the folders above it.

  scripts/check_layers.py               prints each violation, exit status 1 if there is any
  scripts/check_layers.py --self_test   checks the check

Also: ceres::Solve is called in radive/solver/ alone, the library neither exits nor defines flags, and
numbers go to and from text in radive/util/number_text alone, where the locale does not matter.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# In dependency order, as in the README's table.
LAYERS = [
    "util", "geometry", "sensor", "io", "ndt", "neural_map", "factors", "solver", "preprocessing",
    "ego_velocity", "training", "registration", "odometry", "evaluation", "simulation", "config",
    "pipeline", "studies",
]  # fmt: skip

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
FORBIDDEN = [
    (re.compile(r"\bceres::Solve\("), "calls ceres::Solve; only radive/solver/ may", {"solver"}),
    (re.compile(r"(?<![\w.>])(?:std::)?exit\("), "exits; the library returns errors", set()),
    (re.compile(r"\bDEFINE_(?:string|bool|double|u?int(?:32|64))\("), "defines a flag", set()),
    (re.compile(r"\b(?:v?sn?printf|strto(?:d|f|ld)|sto(?:d|f|ld)|ato[fil]|v?sscanf)\("),
     "depends on the locale; use radive/util/number_text.h", {"util"}),
    (re.compile(r"\bsetlocale\(|\blocale::global\("), "changes the locale of the program", set()),
]


def violations(folder, text):
    """Yields (line number, what is wrong) for a source file of radive/FOLDER."""
    if folder not in LAYERS:
        yield 1, f"radive/{folder} is no layer; add it to LAYERS and to the README's table"
        return
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if include:
            parts = include.group(1).split("/")
            if parts[0] in ("apps", "tests", "benchmarks"):
                yield number, f"includes {include.group(1)}; the library stands alone"
            elif parts[0] == "radive" and parts[1] not in LAYERS:
                yield number, f"includes {include.group(1)}, which is in no layer"
            elif parts[0] == "radive" and LAYERS.index(parts[1]) > LAYERS.index(folder):
                yield number, f"includes {include.group(1)}, which is a higher layer"
            continue
        code = line.split("//")[0]
        for pattern, message, allowed in FORBIDDEN:
            if folder not in allowed and pattern.search(code):
                yield number, message


def self_test():
    def count(folder, text):
        return len(list(violations(folder, text)))

    assert count("factors", '#include "radive/geometry/rigid3.h"') == 0
    assert count("factors", '#include "radive/factors/ndt_pair_factor.h"') == 0
    assert count("factors", '#include "radive/odometry/odometry.h"') == 1
    assert count("util", '#include "radive/nowhere/a.h"') == 1
    assert count("util", '#include "tests/shared_data.h"') == 1
    assert count("nowhere", "") == 1
    assert count("registration", "  ceres::Solve(options, &problem, &summary);") == 1
    assert count("solver", "  ceres::Solve(options, &problem, &summary);") == 0
    assert count("odometry", "// never ceres::Solve(...) here") == 0
    assert count("io", "  std::exit(1);") == 1
    assert count("io", "  source.exit(1);") == 0
    assert count("io", "  std::snprintf(text, sizeof(text), form, value);") == 1
    assert count("io", "  value = std::stod(word);") == 1
    assert count("io", "  value = strtod(word, &end);") == 1
    assert count("io", "  text = FormatText(form, value);") == 0
    assert count("util", "  std::vsnprintf(text, sizeof(text), form, values);") == 0
    assert count("util", '  std::setlocale(LC_ALL, "C");') == 1
    assert count("config", 'DEFINE_string(config, "", "");') == 1


def main():
    if sys.argv[1:] == ["--self_test"]:
        self_test()
        return 0
    files = sorted(p for p in (ROOT / "radive").rglob("*") if p.suffix in (".h", ".cc"))
    found = 0
    for path in files:
        relative = path.relative_to(ROOT)
        for number, message in violations(relative.parts[1], path.read_text(encoding="utf-8")):
            print(f"{relative}:{number}: {message}")
            found += 1
    print(f"{len(files)} files, {found} violations of the layers")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())

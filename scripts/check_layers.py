#!/usr/bin/python3
"""Checks the layers of radive/: a folder includes only from itself and from the folders above it.
The same holds among the folders inside radive/io/.

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
    "util", "kernels", "geometry", "sensor", "io", "ndt", "neural_map", "factors", "solver", "preprocessing",
    "ego_velocity", "training", "registration", "odometry", "evaluation", "simulation", "config",
    "pipeline", "studies",
]  # fmt: skip

# Folders inside a layer, in dependency order, as in the README; such a layer has no files of its own.
SUB_LAYERS = {
    "io": ["bytes", "points", "trajectories", "scans", "bags", "datasets", "open"],
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
FORBIDDEN = [
    (re.compile(r"\bceres::Solve\("), "calls ceres::Solve; only radive/solver/ may", {"solver"}),
    (re.compile(r"(?<![\w.>])(?:std::)?exit\("), "exits; the library returns errors", set()),
    (re.compile(r"\bDEFINE_(?:string|bool|double|u?int(?:32|64))\("), "defines a flag", set()),
    (re.compile(r"\b(?:v?sn?printf|strto(?:d|f|ld)|sto(?:d|f|ld)|ato[fil]|v?sscanf)\("),
     "depends on the locale; use radive/util/number_text.h", {"util"}),
    (re.compile(r"[jJ]son::parse\(|\.dump\("), "depends on the locale; use radive/util/json.h",
     {"util"}),
    (re.compile(r"\bsetlocale\(|\blocale::global\("), "changes the locale of the program", set()),
]


def include_violation(folders, target):
    """What is wrong when a file in radive/FOLDERS... includes TARGET, None when nothing is."""
    parts = target.split("/")
    if parts[0] in ("apps", "tests", "benchmarks"):
        return f"includes {target}; the library stands alone"
    if parts[0] != "radive":
        return None
    if parts[1] not in LAYERS:
        return f"includes {target}, which is in no layer"
    if LAYERS.index(parts[1]) > LAYERS.index(folders[0]):
        return f"includes {target}, which is a higher layer"
    if parts[1] == folders[0] and folders[0] in SUB_LAYERS:
        order = SUB_LAYERS[folders[0]]
        if parts[2] not in order:
            return f"includes {target}, which is in no folder of {folders[0]}"
        if order.index(parts[2]) > order.index(folders[1]):
            return f"includes {target}, which is a higher folder of {folders[0]}"
    return None


def violations(folders, text):
    """Yields (line number, what is wrong) for a source file of radive/FOLDERS[0]/FOLDERS[1]..."""
    layer = folders[0]
    if layer not in LAYERS:
        yield 1, f"radive/{layer} is no layer; add it to LAYERS and to the README's table"
        return
    if layer in SUB_LAYERS and (len(folders) < 2 or folders[1] not in SUB_LAYERS[layer]):
        yield 1, f"a file of radive/{layer} is in one of its folders {SUB_LAYERS[layer]}"
        return
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if include:
            wrong = include_violation(folders, include.group(1))
            if wrong:
                yield number, wrong
            continue
        code = line.split("//")[0]
        for pattern, message, allowed in FORBIDDEN:
            if layer not in allowed and pattern.search(code):
                yield number, message


def self_test():
    def count(folder, text):
        return len(list(violations(folder.split("/"), text)))

    assert count("factors", '#include "radive/geometry/rigid3.h"') == 0
    assert count("factors", '#include "radive/factors/ndt_pair_factor.h"') == 0
    assert count("factors", '#include "radive/odometry/odometry.h"') == 1
    assert count("factors", '#include "radive/io/open/open_scan_source.h"') == 0
    assert count("util", '#include "radive/nowhere/a.h"') == 1
    assert count("util", '#include "tests/shared_data.h"') == 1
    assert count("nowhere", "") == 1
    assert count("io/scans", '#include "radive/io/bytes/stamp_text.h"') == 0
    assert count("io/scans", '#include "radive/io/scans/axes.h"') == 0
    assert count("io/scans", '#include "radive/sensor/radar_scan.h"') == 0
    assert count("io/scans", '#include "radive/io/bags/bag_source.h"') == 1
    assert count("io/scans", '#include "radive/io/nowhere/a.h"') == 1
    assert count("io/scans", '#include "radive/io/axes.h"') == 1
    assert count("io/nowhere", "") == 1
    assert count("io", "") == 1
    assert count("registration", "  ceres::Solve(options, &problem, &summary);") == 1
    assert count("solver", "  ceres::Solve(options, &problem, &summary);") == 0
    assert count("odometry", "// never ceres::Solve(...) here") == 0
    assert count("io/bytes", "  std::exit(1);") == 1
    assert count("io/bytes", "  source.exit(1);") == 0
    assert count("io/bytes", "  std::snprintf(text, sizeof(text), form, value);") == 1
    assert count("io/bytes", "  value = std::stod(word);") == 1
    assert count("io/bytes", "  value = strtod(word, &end);") == 1
    assert count("io/bytes", "  text = FormatText(form, value);") == 0
    assert count("util", "  std::vsnprintf(text, sizeof(text), form, values);") == 0
    assert count("pipeline", "  const auto json = nlohmann::json::parse(text);") == 1
    assert count("pipeline", "  return json.dump(2);") == 1
    assert count("pipeline", "  return JsonText(ParseJson(text));") == 0
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
        for number, message in violations(relative.parts[1:-1], path.read_text(encoding="utf-8")):
            print(f"{relative}:{number}: {message}")
            found += 1
    print(f"{len(files)} files, {found} violations of the layers")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
"""Checks the layers of radive/: a folder includes only from itself and from the folders above it.
The same holds among the folders inside radive/io/.

  scripts/check_layers.py               prints each violation, exit status 1 if there is any
  scripts/check_layers.py --self_test   checks the check

Also: ceres::Solve is called in radive/solver/ alone, the library neither exits nor defines flags, and
numbers go to and from text in radive/util/number_text alone, where the locale does not matter; and
what the library target is made of includes nothing of the targets radive_writers and radive_studies.
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
    (re.compile(r"\bstrerror(?:_[lr])?\(|\.message\(\)"),
     "speaks the language of the locale; use radive/util/system_message.h", {"util"}),
    (re.compile(r"[jJ]son::parse\(|\.dump\("), "depends on the locale; use radive/util/json.h",
     {"util"}),
    (re.compile(r"\bsetlocale\(|\blocale::global\("), "changes the locale of the program", set()),
]


SOURCE_LIST = re.compile(r"^set\((radive_\w+)_sources\n(.*?)\)", re.MULTILINE | re.DOTALL)


def separate_targets(cmake):
    """Which files of radive/, without their ending, radive/CMakeLists.txt gives to another target than
    the library."""
    return {pathlib.PurePosixPath(name).with_suffix("").as_posix(): target
            for target, names in SOURCE_LIST.findall(cmake) for name in names.split()}


def target_violations(stem, text, targets):
    """Yields (line number, what is wrong) for the file radive/STEM.* that includes from a target that
    its own does not link: the studies link the writers, the library neither."""
    allowed = {None: set(), "radive_writers": {"radive_writers"},
               "radive_studies": {"radive_writers", "radive_studies"}}[targets.get(stem)]
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if not include or not include.group(1).startswith("radive/"):
            continue
        target = targets.get(include.group(1)[len("radive/"):].rsplit(".", 1)[0])
        if target is not None and target not in allowed:
            yield number, f"includes {include.group(1)}, which is in {target}"


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
    targets = separate_targets(
        "add_library(radive a.cc)\nset(radive_writers_sources\n  io/w.cc\n  io/v.cc)\n"
        "set(radive_studies_sources\n  studies/s.cc)\n")
    assert targets == {"io/w": "radive_writers", "io/v": "radive_writers",
                       "studies/s": "radive_studies"}
    of_writer, of_study = '#include "radive/io/w.h"', '#include "radive/studies/s.h"'
    assert len(list(target_violations("io/r", of_writer, targets))) == 1
    assert not list(target_violations("io/r", '#include "radive/io/x.h"', targets))
    assert not list(target_violations("io/v", of_writer, targets))
    assert not list(target_violations("studies/s", of_writer, targets))
    assert len(list(target_violations("io/w", of_study, targets))) == 1

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
    assert count("io/bytes", "  *error = failure.message();") == 1
    assert count("io/bytes", "  *error = std::strerror(errno);") == 1
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
    targets = separate_targets((ROOT / "radive/CMakeLists.txt").read_text(encoding="utf-8"))
    found = 0 if targets else 1
    for path in files:
        relative = path.relative_to(ROOT)
        text = path.read_text(encoding="utf-8")
        stem = relative.relative_to("radive").with_suffix("").as_posix()
        for number, message in [*violations(relative.parts[1:-1], text),
                                *target_violations(stem, text, targets)]:
            print(f"{relative}:{number}: {message}")
            found += 1
    print(f"{len(files)} files, {found} violations of the layers")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())

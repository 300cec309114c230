#!/usr/bin/python3
"""Checks that README.md and CONTRIBUTING.md speak of the project as it is.

  scripts/check_readme.py BUILD/apps

Every file named in them exists, every file in configs/ and folder of radive/ is named in the README, every
--flag of a radive_* command is one of that program, and every stage.field of a --set is a setting.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP = "radive|apps|tests|benchmarks|configs|scripts|docs"
NAMED_FILE = re.compile(rf"(?<![\w/.=-])((?:{TOP})/[\w./-]*\w/?|[A-Z]+\.(?:md|cff)|LICENSE)")
COMMAND = re.compile(r"\b(radive_\w+)((?:\s+\\?\n?\s*--[\w.=,/:-]+)+)")
GENERATED = re.compile(r"NAME")


def problems(text, apps):
    for name in sorted(set(NAMED_FILE.findall(text))):
        if not GENERATED.search(name) and not (ROOT / name).exists():
            yield f"{name} does not exist"
    help_texts = {}

    def help_of(program, flag):
        if (program, flag) not in help_texts:
            result = subprocess.run(
                [apps / program, flag], stdout=subprocess.PIPE, text=True, check=False
            )
            help_texts[program, flag] = result.stdout
        return help_texts[program, flag]

    for program, flags in COMMAND.findall(text):
        if not (apps / program).exists():
            yield f"{program} is no program"
            continue
        for flag in re.findall(r"--(\w+)", flags):
            if f"--{flag}" not in help_of(program, "--help"):
                yield f"{program} has no flag --{flag}"
    settings = help_of("radive_odometry", "--help_config")
    for stage, field in re.findall(r"(?:--set=|,)([a-z_]+)\.([a-z_]+)=", text):
        if not re.search(rf"^{stage}:\n(?:  .*\n)*?  {field}: ", settings, re.MULTILINE):
            yield f"{stage}.{field} is no setting"


def main():
    apps = pathlib.Path(sys.argv[1])
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    found = list(problems(readme, apps))
    found += problems((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"), apps)
    for config in sorted((ROOT / "configs").glob("*.yaml")):
        if f"configs/{config.name}" not in readme:
            found.append(f"configs/{config.name} is not in the README")
    for parent, prefix in ((ROOT / "radive", ""), (ROOT / "radive" / "io", "io/")):
        for folder in sorted(p for p in parent.iterdir() if p.is_dir()):
            if f"| `{prefix}{folder.name}/` |" not in readme:
                found.append(f"radive/{prefix}{folder.name}/ is not in the README's table")
    for factor in sorted((ROOT / "radive" / "factors").glob("*_factor.h")):
        if f"radive/factors/{factor.name}" not in readme:
            found.append(f"radive/factors/{factor.name} is not in the README's table")
    print("\n".join(found) if found else "README.md and CONTRIBUTING.md fit the project")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

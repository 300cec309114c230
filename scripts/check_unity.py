#!/usr/bin/python3
"""Checks that the files of a folder can be compiled as one (RADIVE_UNITY): their names differ.

  scripts/check_unity.py               prints each name that two files define, exit status 1 if any
  scripts/check_unity.py --self_test   checks the check

Functions may have one name when their parameters differ, and aliases when they mean the same.
"""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

SHARED = re.compile(r"^inline (?:constexpr|const) .*?\b(k[A-Z]\w*)\b", re.M)  # constants of the folder's headers
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.S | re.M)
TYPE = re.compile(r"(?:enum class|enum|struct|class)\s+(\w+)")
ALIAS = re.compile(r"(?:using|namespace)\s+(\w+)\s*=\s*([^;]*)")
FUNCTION = re.compile(r"[\w:<>,&*\s\[\]]*?\b(\w+)\s*\(([^{;]*)\)[^()]*$")
VARIABLE = re.compile(r".*?\b(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=|\{|;|\(|$)")
MACRO = re.compile(r"(?:TEST|TEST_F|TEST_P|INSTANTIATE_TEST_SUITE_P|TYPED_TEST\w*)\b")


def types_of(parameters):
    """The parameters without their names, defaults and blanks."""
    parameters = re.sub(r"=[^,]*", "", parameters)
    return tuple(re.sub(r"\s+|\b\w+$", "", p.strip()) for p in parameters.split(","))


def definitions(text):
    """Yields what the unnamed namespaces of a file define, as (name, what tells overloads apart)."""
    for name in SHARED.findall(text):
        yield name, ("variable",)
    for body in UNNAMED.findall(text):
        body = re.sub(r"//[^\n]*", "", body)
        depth, statement = 0, ""
        for character in body:
            if depth == 0:
                statement += character
            depth += {"{": 1, "}": -1}.get(character, 0)
            if depth == 0 and character in ";}":
                statement = re.sub(r"^\s*template\s*<[^{]*?>\s*(?=\w)", "", statement.strip())
                head = statement.split("{")[0].strip()
                alias, kind = ALIAS.match(head), TYPE.match(head)
                function = None if re.search(r"=(?!=)", head.split("(")[0]) else FUNCTION.match(head)
                if not head.strip(";") or head.startswith("using ") and not alias or MACRO.match(head):
                    pass
                elif alias:
                    yield alias.group(1), ("alias", " ".join(alias.group(2).split()))
                elif kind:
                    yield kind.group(1), ("type",)
                elif function and "{" in statement:
                    yield function.group(1), ("function", types_of(function.group(2)))
                elif head.startswith(("constexpr", "const", "inline", "thread_local", "static", "std")):
                    variable = VARIABLE.match(head)
                    if variable and variable.group(1) not in ("struct", "enum", "union"):
                        yield variable.group(1), ("variable",)
                statement = ""


def clash(first, second):
    if first[0] == second[0] == "alias":
        return first != second
    if first[0] == second[0] == "function":
        return first == second
    return True


def clashes(texts):
    """Yields (name, file, file) for the files of a folder, as {file: text}."""
    seen = collections.defaultdict(list)
    for file, text in texts.items():
        for name, what in definitions(text):
            for other, other_what in seen[name]:
                if other != file and clash(what, other_what):
                    yield name, other, file
                    break
            seen[name].append((file, what))


def self_test():
    def count(*bodies):
        texts = {str(i): f"namespace {{\n{b}\n}}  // namespace\n" for i, b in enumerate(bodies)}
        return len(list(clashes(texts)))

    assert count("constexpr int kA = 1;", "constexpr double kA = 2.0;") == 1
    assert count("constexpr int kA = 1;", "constexpr int kB = 1;") == 0
    assert count("int F(int a) { return a; }", "int F(int b) { return b; }") == 1
    assert count("int F(int a) { return a; }", "int F(double a) { return 1; }") == 0
    assert count("struct S {\n  int F() { return 1; }\n};", "class S {\n};") == 1
    assert count("using A = int;", "using A = int;") == 0
    assert count("using A = int;", "using A = double;") == 1
    assert count("struct S {\n};", "int S(int a) { return a; }") == 1
    assert count("TEST(A, B) { F(1); }", "TEST(A, C) { F(1); }") == 0
    assert count("const std::vector<int> kA = {1, 2};", "const Vector3d kA(1, 2, 3);") == 1


def main():
    if sys.argv[1:] == ["--self_test"]:
        self_test()
        return 0
    folders = collections.defaultdict(dict)
    for top in ("radive", "tests"):
        for path in sorted((ROOT / top).rglob("*")):
            # Each of fuzz is a program of its own.
            if path.suffix in (".h", ".cc") and "fuzz" not in path.parts:
                folders[path.parent.relative_to(ROOT)][path.name] = path.read_text()
    found = [(folder, *c) for folder, texts in folders.items() for c in clashes(texts)]
    for folder, name, first, second in found:
        print(f"{folder}: {name} is defined in {first} and in {second}")
    print(f"{sum(map(len, folders.values()))} files, {len(found)} clashes of names")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

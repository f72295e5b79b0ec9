#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutants.py [COUNT [SEED]]: which single wrong operators in the core's sources its tests find.

Takes COUNT operators, 100 by default and the same in each run of a SEED, out of src/model, src/solve and src/airlight, puts
a wrong one in the place of each in a copy of the tree (build-mutants/tree), and runs the core's tests. Prints the mutants
and adds them to data/benchmarks/mutants.csv.
"""

import csv
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

root = pathlib.Path(__file__).resolve().parents[2]
build = root / "build-mutants"
tree = build / "tree"
wrong = {
    "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"],
    "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
}  # fmt: skip
operator = re.compile(r"(?<= )(" + "|".join(re.escape(text) for text in sorted(wrong, key=len, reverse=True)) + r")(?= )")


def sites(path):
    """The binary operators of a file, which stand between spaces: line, column, text."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        code = re.sub(r'"(\\.|[^"\\])*"', lambda text: " " * len(text[0]), line.split("//")[0])
        if code.lstrip().startswith(("#", "template", "using ", "static_assert", "assert(")):
            continue
        for found in operator.finditer(code):
            yield number, found.start(), found[0]


def make(quiet=True):
    return subprocess.run(["ninja", "-C", build, "litfog_core_tests", "litfog_thread_tests"],
                          capture_output=quiet).returncode == 0  # fmt: skip


def run(name, filters, limit):
    """The first test that fails, or None."""
    command = [build / "tests" / "core" / name, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={filters}"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=limit)
    except subprocess.TimeoutExpired:
        return "the limit of time"
    failed = re.search(r"^\[  FAILED  \] (\S+) \(", done.stdout, re.MULTILINE)
    return None if done.returncode == 0 else failed[1] if failed else "a crash"


def found_by(filters, limit):
    """The first of the tests that finds the mutant of now, or None. Updater and clusters are not of these folders."""
    joint = ":" if "-" in filters else "-"
    return (run("litfog_core_tests", filters, limit)
            or run("litfog_thread_tests", f"{filters}{joint}FogUpdater*:LightClusters*", limit))  # fmt: skip


def own_tests(path):
    """The tests in the files that have the beginning of a word of a source's name in theirs."""
    folder = tree / "tests" / "core"
    files = {test for word in path.stem.split("_") for test in folder.glob(f"*{word[:7]}*_test.cpp")}
    text = "".join(test.read_text(encoding="utf-8") for test in files)
    names = re.findall(r"^\w+\((\w+), (\w+)", text, re.MULTILINE)
    return ":".join(sorted(f"{suite}.{name}" for suite, name in set(names))) or "none"


class Mutant:
    """An operator replaced in a file, as long as this is entered."""

    def __init__(self, path, site, text):
        self.path, (self.line, self.column, self.operator), self.text = path, site, text
        self.found = None
        self.original = path.read_text(encoding="utf-8")

    def __enter__(self):
        lines = self.original.splitlines(keepends=True)
        line = lines[self.line - 1]
        lines[self.line - 1] = line[:self.column] + self.text + line[self.column + len(self.operator):]
        self.path.write_text("".join(lines), encoding="utf-8")
        if not make():
            self.found = "the compiler"
        return self

    def __exit__(self, *_):
        self.path.write_text(self.original, encoding="utf-8")
        place = f"{self.path.relative_to(tree)}:{self.line}:{self.column + 1}"
        print(f"{place}: {self.operator} to {self.text}: {self.found}", flush=True)


count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
shutil.rmtree(tree, ignore_errors=True)
tree.mkdir(parents=True)
subprocess.run(f"git -C {root} ls-files -z | tar -C {root} --null -T - -c | tar -C {tree} -x", shell=True, check=True)
subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "--log-level=NOTICE", "-DCMAKE_BUILD_TYPE=Debug",
                "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -DHWY_COMPILE_ONLY_STATIC", "-DLITFOG_BUILD_FIT=OFF",
                "-DLITFOG_BUILD_APPS=OFF", "-DLITFOG_BUILD_GL=OFF", "-DLITFOG_BUILD_TESTS=ON"], check=True)  # fmt: skip
assert make(quiet=False)
files = [path for folder in ("model", "solve", "airlight") for path in sorted((tree / "src" / folder).glob("*.cpp"))]
choice = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 44)
mutants = [Mutant(path, site, choice.choice(wrong[site[2]]))
           for path, site in choice.sample([(path, site) for path in files for site in sites(path)], count)]  # fmt: skip
for mutant in mutants:  # its own tests find most of them soon
    with mutant:
        mutant.found = mutant.found or found_by(own_tests(mutant.path), 600)
start = time.monotonic()
assert make() and not found_by("*", None), "the tests fail without a mutant"
limit = 4 * (time.monotonic() - start)
for mutant in mutants:
    if not mutant.found:
        with mutant:
            mutant.found = found_by(f"*-{own_tests(mutant.path)}", limit)

print(f"{sum(bool(mutant.found) for mutant in mutants)} of {len(mutants)} found")
path = root / "data" / "benchmarks" / "mutants.csv"
with open(path, encoding="utf-8", newline="") as file:
    rows = {tuple(row[:4]): row[4] for row in csv.reader(file)}
rows |= {(str(mutant.path.relative_to(tree)), str(mutant.line), mutant.operator, mutant.text): mutant.found or ""
         for mutant in mutants}  # fmt: skip
with open(path, "w", encoding="utf-8", newline="") as file:
    csv.writer(file, lineterminator="\n").writerows([*key, found] for key, found in rows.items())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutants.py [COUNT [SEED]]: which single wrong operators in the core's sources its tests find.

Takes COUNT operators, 100 by default and the same in each run of a SEED, out of the core's sources and the shaders whose
text they share, puts a wrong one in the place of each in a copy of the tree (build-mutants/tree), and runs the core's
tests. Prints each mutant and adds it to data/benchmarks/mutants.csv.
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
    """The first of the tests that finds the mutant of now, or None."""
    return run("litfog_core_tests", filters, limit) or run("litfog_thread_tests", filters, limit)


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
subprocess.run(f"git -C {root} ls-files -z | tar -C {root} --null -T - -c | tar -C {tree} -xm", shell=True, check=True)
subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "--log-level=NOTICE", "-DCMAKE_BUILD_TYPE=Debug",
                "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -march=native -DHWY_COMPILE_ONLY_STATIC", "-DLITFOG_BUILD_FIT=OFF",
                "-DLITFOG_BUILD_APPS=OFF", "-DLITFOG_BUILD_GL=OFF", "-DLITFOG_BUILD_TESTS=ON"], check=True)  # fmt: skip
assert make(quiet=False)
files = [path for folder in ("model", "solve", "airlight", "culling", "tables")
         for path in sorted((tree / "src" / folder).glob("*.*"))]  # fmt: skip
including = "".join(path.read_text(encoding="utf-8") for path in [*files, tree / "include" / "litfog" / "formulas.h"])
files += [tree / "include" / shader
          for shader in sorted(set(re.findall(r'^#include "(litfog/shaders/.*)"', including, re.MULTILINE)))]  # fmt: skip
choice = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 44)
mutants = [Mutant(path, site, choice.choice(wrong[site[2]]))
           for path, site in choice.sample([(path, site) for path in files for site in sites(path)], count)]  # fmt: skip
start = time.monotonic()
assert not found_by("*", None), "the tests fail without a mutant"
limit = 4 * (time.monotonic() - start)
table = root / "data" / "benchmarks" / "mutants.csv"
for mutant in mutants:
    with mutant:  # its own tests find most of them soon
        own = own_tests(mutant.path)
        mutant.found = mutant.found or found_by(own, limit) or found_by(f"*-{own}", limit)
    key = [str(mutant.path.relative_to(tree)), str(mutant.line), mutant.operator, mutant.text]
    with open(table, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.reader(file) if row[:4] != key]
    with open(table, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([*rows, [*key, mutant.found or ""]])
print(f"{sum(bool(mutant.found) for mutant in mutants)} of {len(mutants)} found")

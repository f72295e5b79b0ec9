#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutants.py [COUNT [SEED [FOLDER...]]]: which single wrong operators in the sources of FOLDERs their tests find.

Takes COUNT operators, 100 by default and the same in each run of a SEED, out of the sources in FOLDERs, by default the
core's, with the shaders whose text they share. Puts a wrong one in the place of each in a copy of the tree
(build-mutants/tree), and runs the folder's tests. Prints each mutant and adds those that compile to data/benchmarks/mutants.csv.
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
core = ["core/litfog_core_tests", "core/litfog_thread_tests"]
programs = {
    **dict.fromkeys(["src/airlight", "src/culling", "src/model", "src/solve", "src/tables"], core),
    "apps/scene/file": ["scene/litfog_scene_file_tests", "scene/litfog_scene_tests"],
    "src/c": ["c/litfog_c_tests"],
    "src/files": ["files/litfog_files_tests", "files/litfog_whole_file_tests"],
    "src/fit": ["fit/litfog_fit_tests"],
    "src/photometry": ["photometry/litfog_photometry_tests"],
    "src/text": ["core/litfog_thread_tests", "files/litfog_files_tests"],
}  # a folder's tests
wrong = {
    "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"],
    "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
    "min": ["max"], "max": ["min"], "Min": ["Max"], "Max": ["Min"], "true": ["false"], "false": ["true"],
}  # fmt: skip
symbols = "|".join(re.escape(text) for text in sorted(wrong, key=len, reverse=True) if not text.isalpha())
operator = re.compile(rf"(?<= )({symbols})(?= )|\b({'|'.join(filter(str.isalpha, wrong))})\b")


def sites(path):
    """The operators of a file, binary ones between spaces: line, column, text."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        code = re.sub(r'"(\\.|[^"\\])*"', lambda text: " " * len(text[0]), line.split("//")[0])
        if code.lstrip().startswith(("#", "template", "using ", "static_assert", "assert(")):
            continue
        for found in operator.finditer(code):
            yield number, found.start(), found[0]


def tests_of(path):
    """The programs whose tests a source's are."""
    return programs.get(str(path.parent.relative_to(tree)), core)


def make(paths, quiet=True):
    targets = {pathlib.Path(program).name for path in paths for program in tests_of(path)}
    return subprocess.run(["ninja", "-C", build, *targets], capture_output=quiet).returncode == 0


def found_by(path, filters, limit):
    """The first of a source's tests that fails, or None."""
    for program in tests_of(path):
        command = [build / "tests" / program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={filters}"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=limit)
        except subprocess.TimeoutExpired:
            return "the limit of time"
        if done.returncode != 0:
            failed = re.search(r"^\[  FAILED  \] (\S+) \(", done.stdout, re.MULTILINE)
            return failed[1] if failed else "a crash"
    return None


def own_tests(path):
    """The tests in the files that have the beginning of a word of a source's name in theirs."""
    files = {test for program in tests_of(path) for word in path.stem.split("_")
             for test in (tree / "tests" / program).parent.glob(f"*{word[:7]}*_test.cpp")}  # fmt: skip
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
        if not make([self.path]):
            self.found = "the compiler"
        return self

    def __exit__(self, *_):
        self.path.write_text(self.original, encoding="utf-8")
        place = f"{self.path.relative_to(tree)}:{self.line}:{self.column + 1}"
        print(f"{place}: {self.operator} to {self.text}: {self.found}", flush=True)


count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
folders = sys.argv[3:] or [folder for folder, tests in programs.items() if tests is core]
for folder in folders:
    if folder not in programs:
        sys.exit(f"mutants.py: FOLDER = {folder}: must be one of {', '.join(programs)}")
shutil.rmtree(tree, ignore_errors=True)
tree.mkdir(parents=True)
subprocess.run(f"git -C {root} ls-files -z | tar -C {root} --null -T - -c | tar -C {tree} -xm", shell=True, check=True)
subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "--log-level=NOTICE", "-DCMAKE_BUILD_TYPE=Debug",
                "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -march=native -DHWY_COMPILE_ONLY_STATIC", "-DLITFOG_BUILD_TESTS=ON"],
               check=True)  # fmt: skip
files = [path for folder in folders for path in sorted((tree / folder).glob("*.*")) if path.suffix != ".txt"]
if "src/airlight" in folders:
    including = "".join(path.read_text(encoding="utf-8") for path in [*files, tree / "include/litfog/formulas.h"])
    shaders = sorted(set(re.findall(r'^#include "(litfog/shaders/.*)"', including, re.MULTILINE)))
    files += [tree / "include" / shader for shader in shaders]
assert make(files, quiet=False)
choice = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 44)
mutants = [Mutant(path, site, choice.choice(wrong[site[2]]))
           for path, site in choice.sample([(path, site) for path in files for site in sites(path)], count)]  # fmt: skip
start = time.monotonic()
for path in {tuple(tests_of(path)): path for path in files}.values():
    assert not found_by(path, "*", None), "the tests fail without a mutant"
limit = 4 * (time.monotonic() - start)
table = root / "data" / "benchmarks" / "mutants.csv"
for mutant in mutants:
    with mutant:  # its own tests find most of them soon
        own = own_tests(mutant.path)
        mutant.found = mutant.found or found_by(mutant.path, own, limit) or found_by(mutant.path, f"*-{own}", limit)
    if mutant.found == "the compiler":
        continue
    key = [str(mutant.path.relative_to(tree)), str(mutant.line), mutant.operator, mutant.text]
    with open(table, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.reader(file) if row[:4] != key]
    with open(table, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([*rows, [*key, mutant.found or ""]])
print(f"{sum(bool(mutant.found) for mutant in mutants)} of {len(mutants)} found")

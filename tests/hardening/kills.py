#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""kills.py COUNT COMMAND...: what a command leaves that a signal ends at COUNT random moments.

The command writes into the folder out of where it runs, each time into what the last one left. Whatever of its files is
there has to be whole: as a run to the end writes it, or the first line that marks the page of a catalogue as one. The
next run to the end has to leave no temporary.
"""

import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

count, command = int(sys.argv[1]), sys.argv[2:]
moments = random.Random(44)


def start(folder):
    folder.mkdir(exist_ok=True)
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)


def finish(folder):
    process = start(folder)
    _, error = process.communicate()
    assert process.returncode == 0, error.decode(errors="replace")


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


with tempfile.TemporaryDirectory() as folder:
    whole, cut = pathlib.Path(folder) / "whole", pathlib.Path(folder) / "cut"
    finish(whole)
    begin = time.monotonic()
    finish(whole)
    seconds = time.monotonic() - begin
    expected = files(whole)
    temporaries = kills = 0
    for _ in range(count):
        process = start(cut)
        try:
            process.wait(moments.uniform(0, seconds))
        except subprocess.TimeoutExpired:
            kills += 1
        process.send_signal(signal.SIGKILL)
        process.communicate()
        for name, content in files(cut).items():
            if pathlib.Path(name).name.startswith(".litfog-"):
                temporaries += 1
            elif content != expected[name]:
                assert content == expected[name].splitlines(keepends=True)[0], f"{name} is not whole"
        if moments.random() < 0.3:
            for path in cut.rglob("*"):
                if path.is_file() and not path.name.startswith(".litfog-"):
                    path.unlink()
    finish(cut)
    assert files(cut) == expected, sorted(files(cut).keys() ^ expected.keys())
print(f"{kills} kills, {temporaries} temporaries seen, none left")

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""catalogue.py COUNT LITFOG-FIT: time and memory of a catalogue of COUNT photometric files.

They are the lamps of tests/data/photometry, each with a multiplier of its own. Every one has to be in the table.
"""

import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

count, command = int(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
data = pathlib.Path(__file__).resolve().parents[1] / "data" / "photometry"
lamps = [data / f"{name}.ies" for name in ("approach_light", "landing_lamp", "edition_2002")]
with tempfile.TemporaryDirectory() as folder:
    files = pathlib.Path(folder) / "files"
    files.mkdir()
    for i in range(count):
        lamp = lamps[i % len(lamps)]
        head, tilt, numbers = lamp.read_text(encoding="latin-1").partition("TILT=NONE")
        lamps_lumens_multiplier = re.compile(r"(\s*\S+\s+\S+\s+)\S+")
        text = head + tilt + lamps_lumens_multiplier.sub(rf"\g<1>{1 + i / count:.6f}", numbers, count=1)
        (files / f"{lamp.stem}_{i}.ies").write_text(text, encoding="latin-1")
    start = time.monotonic()
    done = subprocess.run([command, files, "--catalogue", "out", "--format", "csv"], cwd=folder, capture_output=True,
                          text=True, check=False)  # fmt: skip
    seconds = time.monotonic() - start
    assert done.returncode in (0, 5), done.stderr[-2000:]
    assert done.stdout.count("\n") == count + 1, done.stdout[:2000]
    assert len(list((pathlib.Path(folder) / "out" / "lamps").glob("*.json"))) == count
mebibytes = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(f"{count} files: {seconds:.1f} s, at most {mebibytes:.0f} MiB")

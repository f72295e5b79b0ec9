# SPDX-License-Identifier: Apache-2.0
"""A catalogue of photometric files that may be too many for one machine, fitted by litfog-fit over Dask.

    python3 catalogue.py FOLDER LIGHTS                        in this process
    python3 catalogue.py FOLDER LIGHTS --workers 4            by four worker processes on this machine
    python3 catalogue.py FOLDER LIGHTS --scheduler tcp://head:8786

Every photometric file in FOLDER and below becomes a light file in LIGHTS, LIGHTS/maker/lamp.json of FOLDER/maker/lamp.ies.
litfog-fit's table of them goes to standard output, a row each, and what it says of poor lights and bad files to standard
error. All are the same, to the byte, wherever the files are fitted, on processors with the same SIMD instructions. Every
worker must see FOLDER by the same path, and have litfog-fit. A chunk (chunks.py) is of up to 100 files of one folder. On one
machine litfog-fit takes all cores by itself: there --workers is to try it.
"""

import argparse
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile

import chunks

CHUNK = 100  # files
ENDINGS = {".csv", ".gldf", ".ies", ".ldt", ".xml"}


def fit_chunk(folder, names):
    """Table, messages and lights, by name, of some files of a folder."""
    with tempfile.TemporaryDirectory() as lights:
        ended = subprocess.run(
            ["litfog-fit", "--format", "csv", "-o", lights, "--", *names],
            cwd=folder, capture_output=True, encoding="utf-8", errors="replace",
        )  # fmt: skip
        if ended.returncode not in (0, 2, 5):  # 2 bad files, 5 poor lights: the others are fitted all the same
            raise RuntimeError(ended.stderr)
        return ended.stdout, ended.stderr, {file.name: file.read_text() for file in pathlib.Path(lights).iterdir()}


def chunks_of(folder):
    """By number: a folder below it, and names of files there, all in the order of their paths."""
    by_parent, lights = {}, set()
    for file in sorted(folder.rglob("*")):
        if file.suffix.lower() in ENDINGS and file.is_file():
            by_parent.setdefault(file.parent, []).append(file.name)
            if file.with_suffix("") in lights:
                raise SystemExit(f"{file}: must not differ from another file in its ending alone: one light for two")
            lights.add(file.with_suffix(""))
    parts = [
        (str(parent), names[first : first + CHUNK])
        for parent, names in by_parent.items()
        for first in range(0, len(names), CHUNK)
    ]
    return dict(enumerate(parts))


def gather(results, parts, folder, lights):
    """Writes the lights, and returns the rows of the whole table and all messages."""
    chunks.require_all(results, parts)
    rows, messages = [], []
    for number, (parent, _) in parts.items():
        table, said, texts = results[number]
        below = pathlib.Path(parent).relative_to(folder)
        (lights / below).mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            (lights / below / name).write_text(text, encoding="utf-8")
        header, *chunk_rows = csv.reader(table.splitlines())
        rows = rows or [header]
        rows += [[str(below / name), *values] for name, *values in chunk_rows]
        messages += [str(below / line) for line in said.splitlines()]
    return rows, messages


def main():
    parser = argparse.ArgumentParser(description="Lights from many photometric files.")
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER", help="of photometric files, at any depth")
    parser.add_argument("lights", type=pathlib.Path, metavar="LIGHTS", help="folder for the light files")
    chunks.add_options(parser)
    options = parser.parse_args()
    folder = options.folder.absolute()
    parts = chunks_of(folder)
    if not parts:
        parser.error(f"{folder} holds no photometric file")
    if not options.scheduler and shutil.which("litfog-fit") is None:
        parser.error("litfog-fit must be in PATH: install litfog-tools")
    try:
        options.lights.mkdir(parents=True, exist_ok=True)
    except OSError as error:  # now, and not after hours of fits
        parser.error(f"{options.lights}: cannot be made: {error.strerror}")
    rows, messages = gather(chunks.run(fit_chunk, parts, options), parts, folder, options.lights)
    for message in messages:
        print(message, file=sys.stderr)
    csv.writer(sys.stdout, lineterminator="\n").writerows(rows)


if __name__ == "__main__":
    main()

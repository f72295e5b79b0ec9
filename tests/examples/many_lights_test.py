# SPDX-License-Identifier: Apache-2.0
"""The host of many lamps draws the same picture by clusters as by all lamps, and one of 5,000 lamps.

python3 many_lights_test.py <many_lights_host> <picture to write>
"""

import subprocess
import sys

program, picture = sys.argv[1:]


def draw(*arguments):
    status = subprocess.run([program, picture, *arguments]).returncode
    if status != 0:
        sys.exit(status)  # 3: skipped
    with open(picture, "rb") as file:
        return file.read().split(b"\n", 1)


for arguments, error in ((["x"], "SIZE = x: must be a whole number in [1, 4096]\n"),
                         (["0"], "SIZE = 0: must be a whole number in [1, 4096]\n"),
                         (["36", "-5"], "LAMPS = -5: must be a whole number in [1, 100000]\n")):
    ended = subprocess.run([program, picture, *arguments], stderr=subprocess.PIPE, text=True)
    assert (ended.returncode, ended.stderr) == (1, error), ended
size, by_clusters = draw("36", "500")
_, by_all = draw("36", "500", "all")
assert size == b"P6 36 144 255" and len(by_clusters) == len(by_all) == 36 * 144 * 3
largest = max(abs(a - b) for a, b in zip(by_clusters, by_all))
assert largest <= 1, f"{largest} of 255 apart"
size, odd = draw("37", "500")  # rows of 111 bytes
assert size == b"P6 37 148 255" and len(odd) == 37 * 148 * 3, size
assert max(by_all) > 100, "the picture is dark"
many = sum(draw("36")[1])
assert many > 2 * sum(by_all), "5,000 lamps are no brighter than 500"

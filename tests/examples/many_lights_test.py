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


size, by_clusters = draw("36", "500")
_, by_all = draw("36", "500", "all")
assert size == b"P6 36 144 255" and len(by_clusters) == len(by_all) == 36 * 144 * 3
largest = max(abs(a - b) for a, b in zip(by_clusters, by_all))
assert largest <= 1, f"{largest} of 255 apart"
assert max(by_all) > 100, "the picture is dark"
many = sum(draw("36")[1])
assert many > 2 * sum(by_all), "5,000 lamps are no brighter than 500"

# SPDX-License-Identifier: Apache-2.0
"""The host of the CIGI example: packs each field by itself, as the interface control document lists them.

python3 cigi_test.py <cigi_ig>
"""

import math
import random
import re
import socket
import struct
import subprocess
import sys
import time

program = sys.argv[1]


def ig_control(version, order, frame):
    if version == 3:
        # id, size, major, database, minor and flags, reserved, byte swap, frame, timestamp, last IG frame, reserved
        return struct.pack(order + "BBBbBBHIIII", 1, 24, 3, 1, 0x31, 0, 0x8000, frame, 0, 0, 0)
    # size, id, major, database, entity type substitution, minor and flags, frame, last IG frame, timestamp, reserved
    return struct.pack(order + "HHBbBBIIII", 24, 0, 4, 1, 0, 0x01, frame, 0, 0, 0)


def atmosphere(version, order, visibility):
    # air temperature, visibility, horizontal and vertical wind speed, wind direction, pressure
    fields = struct.pack(order + "ffffff", 15, visibility, 3, 0, 90, 1013)
    if version == 3:  # id, size, flags, humidity; reserved at the end
        return struct.pack(order + "BBBB", 10, 32, 1, 30) + fields + bytes(4)
    return struct.pack(order + "HHBBH", 32, 9, 0x80 | 30, 0, 0) + fields  # size, id, enabled and humidity, reserved


def weather(version, order, layer, scope, enabled, visibility, base=0, thickness=200, upper=10):
    # temperature, visibility, scud frequency, coverage, base, thickness, transition, wind (3), pressure, aerosol
    fields = struct.pack(order + "12f", 15, visibility, 0, 100, base, thickness, 10, 0, 0, 0, 1013, 0)
    flags = bytes([layer, 30, int(enabled), scope])
    if version == 3:  # id, size, region
        return struct.pack(order + "BBH", 12, 56, 0) + flags + fields
    # size, id; region, reserved; top scud frequency, top transition, reserved
    top = struct.pack(order + "fff", 0, upper, 0)
    return struct.pack(order + "HH", 72, 11) + flags + struct.pack(order + "HH", 0, 0) + fields + top


class ImageGenerator:
    """The example, from its start to its last line."""

    def __init__(self, datagrams):
        self.process = subprocess.Popen([program, "0", str(datagrams)], stdout=subprocess.PIPE, text=True)
        self.port = int(self.process.stdout.readline().split()[1])
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def send(self, datagram):
        self.socket.sendto(datagram, ("127.0.0.1", self.port))

    def lines(self):
        output = self.process.communicate(timeout=60)[0]
        assert self.process.returncode == 0, self.process.returncode
        self.socket.close()
        return output.splitlines()


def density_of(visibility):
    return -math.log(0.05) / visibility


# A visibility, layers with it, and clear again, in both versions and both byte orders. The eye is 3 m up.
datagrams, seen = [], []  # seen: density at the eye, knots and what is ignored, or None where nothing changes
for version in (3, 4):
    for order in "<>":
        start = lambda: ig_control(version, order, len(datagrams) + 0x01020300)
        ground = lambda *state: weather(version, order, *state)
        unknown = struct.pack("BB", 200, 8) if version == 3 else struct.pack(order + "HHH", 8, 0x2000, 0)
        unknown = unknown.ljust(8, b"\0")
        band = "the width of the upper band of layer 2" if version == 4 else ""
        for extra, expected in (
            (unknown + atmosphere(version, order, 1500), (density_of(1500), 0, "")),
            (ground(0, 0, True, 200), (density_of(1500) + density_of(200), 2, "")),
            (ground(4, 0, True, 10) + ground(0, 1, True, 10), None),  # rain, a region: not the fog of the scene
            (atmosphere(version, order, 150), (density_of(150) + density_of(200), 2, "")),
            (ground(1, 0, True, 50, 300, 100), (density_of(150) + density_of(200), 6, "")),  # a cloud above
            (ground(2, 0, True, 50, 800, 100), (density_of(150) + density_of(200), 6, "layer 2")),  # one too many
            (ground(3, 0, True, 50, 600, 100), (density_of(150) + density_of(200), 6, "layer 3, layer 2")),
            (ground(3, 0, False, 0), (density_of(150) + density_of(200), 6, "layer 2")),
            (ground(0, 0, True, 200, -20, 18), (density_of(150) + density_of(200) / 2, 6, "layer 2")),  # half out of it
            (ground(0, 0, False, 10) + atmosphere(version, order, math.inf), (0, 8, "")),  # room for both clouds
            (ground(2, 0, True, 50, 800, 100, 25), (0, 8, band) if band else None),
            (ground(1, 0, False, 0) + ground(2, 0, False, 0) + atmosphere(version, order, 0), (math.inf, 0, "")),
        ):
            datagrams.append(start() + extra)
            seen.append(expected)
ig = ImageGenerator(len(datagrams))
for datagram in datagrams:
    ig.send(datagram)
lines = ig.lines()
expected = [(i, *v) for i, v in enumerate(seen) if v is not None]
assert len(lines) == len(expected) + 1, lines
reported = r"frame (\d+), CIGI (\d): density (\S+)/m at the eye, (\d) knots, \d+ bytes of lights to upload(?:; ignored: (.+))?$"
for line, (i, wanted, knots, ignored) in zip(lines, expected):
    frame, version, density, count, told = re.match(reported, line).groups()
    assert (told or "") == ignored, line
    assert (int(frame), int(version)) == (0x01020300 + i, 3 if i < len(datagrams) / 2 else 4), line
    assert math.isclose(float(density), wanted, rel_tol=1e-5) and int(count) == knots, line
assert lines[-1].startswith(f"{len(datagrams)} datagrams, 0 refused"), lines[-1]

# What is wrong is refused by name, whole, and the fog before it stays.
good = ig_control(3, "<", 1) + atmosphere(3, "<", 1500)
good4 = ig_control(4, ">", 1) + atmosphere(4, ">", 1500)
refused = [
    (b"", "datagram of 0 bytes"),
    (good[:23], "datagram of 23 bytes"),
    (good[:40], "packet 10 of size 32"),
    (good4[:40], "packet 9 of size 32"),
    (good[:26], "truncated packet"),
    (good + bytes(4), "packet 0 of size 0"),
    (good[:25] + b"\x18" + good[26:], "packet 10 of size 24"),
    (good[:6] + b"\x12\x34" + good[8:], "no byte order"),
    (b"\x02" + good[1:], "no IG Control of CIGI 3 or 4 begins it"),
    (good[:2] + b"\x02" + good[3:], "no IG Control of CIGI 3 or 4 begins it"),
    (good + good, "IG Control not first and once"),
    (ig_control(3, "<", 1) + atmosphere(3, "<", math.nan), "visibility = nan: must be >= 0"),
    (ig_control(4, "<", 1) + atmosphere(4, "<", -1), "visibility = -1: must be >= 0"),
    (ig_control(4, "<", 1) + atmosphere(4, "<", 10) + atmosphere(4, "<", math.nan), "visibility = nan: must be >= 0"),
    (ig_control(3, "<", 1) + weather(3, "<", 1, 0, True, 0), "layer 1: visibility = 0: must be > 0"),
    (ig_control(4, ">", 1) + weather(4, ">", 2, 0, True, 9, 100, -1), "layer 2: top = 99: must be above the base"),
]
ig = ImageGenerator(len(refused) + 2)
for datagram in [good] + [d for d, _ in refused] + [good]:
    ig.send(datagram)
lines = ig.lines()
assert lines[0].startswith("frame 1, CIGI 3: density 0.00199715/m"), lines[0]
for line, (_, reason) in zip(lines[1:], refused):
    assert line == "refused: " + reason, (line, reason)
assert lines[-1].startswith(f"{len(refused) + 2} datagrams, {len(refused)} refused"), lines[-1]

# Whatever arrives, it goes on.
noise = random.Random(15)
ig = ImageGenerator(1000)
for i in range(1000):
    datagram = bytearray(noise.choice(datagrams))
    for _ in range(noise.randrange(4)):
        datagram[noise.randrange(len(datagram))] = noise.randrange(256)
    ig.send(bytes(datagram[: noise.randrange(len(datagram) + 1)] if noise.random() < 0.3 else datagram))
    if i % 50 == 49:
        time.sleep(0.01)  # the socket's buffer is finite
assert re.match(r"1000 datagrams, \d{3} refused, latency ", ig.lines()[-1])

# Arguments that are no numbers in their range are refused by name.
for arguments, name in ((["70000", "1"], "PORT = 70000"), (["0", "-1"], "DATAGRAMS = -1"), (["0", "2x"], "DATAGRAMS = 2x")):
    ended = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60)
    assert ended.returncode == 1 and ended.stderr.startswith(name + ": must be a whole number in ["), ended

# At 60 Hz it keeps up: the ranges of a frame are known before the next.
ig = ImageGenerator(60)
for i in range(60):
    ig.send(ig_control(4, "<", i) + atmosphere(4, "<", 2000 - 30 * i))
    time.sleep(1 / 60)
lines = ig.lines()
assert len(lines) == 61, lines
median = int(re.search(r"latency median (\d+) us, p99 \d+ us$", lines[-1]).group(1))
assert median < 1e6 / 60, lines[-1]
print(lines[-1])

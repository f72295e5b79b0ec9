# SPDX-License-Identifier: Apache-2.0
"""`import litfog.pictures` beside the command litfog-demo.

pictures_test.py <litfog-demo> <pictures.pyi>
"""

import ast
import math
import os
import pathlib
import pickle
import re
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import zlib

import litfog
import litfog.pictures
import numpy as np
from litfog.pictures import render

demo_command, stub_file = sys.argv[1:3]
ROOM = {"size": (48, 27), "samples": 1, "path": "legacy"}  # cheap


def png_pixels(path):
    """An 8-bit RGB .png without interlacing as an array."""
    data = pathlib.Path(path).read_bytes()
    chunks, at = {}, 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        name = data[at + 4 : at + 8]
        chunks[name] = chunks.get(name, b"") + data[at + 8 : at + 8 + length]
        at += 12 + length
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    assert chunks[b"IHDR"][8:] == b"\x08\x02\0\0\0"
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, 1 + 3 * width)
    pixels = np.zeros((height + 1, 3 * (width + 1)), int)  # a row above and a pixel to the left are 0
    for y, row in enumerate(rows):
        for x in range(3 * width):
            left, above, corner = pixels[y + 1, x], pixels[y, x + 3], pixels[y, x]
            nearest = min((left, above, corner), key=lambda value: abs(left + above - corner - value))
            predicted = (0, left, above, (left + above) // 2, nearest)[row[0]]
            pixels[y + 1, x + 3] = (row[1 + x] + predicted) % 256
    return pixels[1:, 3:].reshape(height, width, 3)


class PicturesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        try:
            cls.room = render("room", visibility=20, **ROOM)
        except litfog.pictures.Unsupported as missing:
            if "LITFOG_REQUIRE_GL" in os.environ:
                raise
            raise unittest.SkipTest(str(missing))

    def test_pixels_are_those_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = f"{folder}/picture.png"
            subprocess.run(
                [demo_command, "room", "--fog", "exp2", "--visibility", "12.5", "--camera", "2,1.6,4", "--target=-1,1.5,-2"]
                + ["--set", "lights[0].attenuation.quadratic=0.02", "--set", "lights[0].color=[1,0.5,0]"]
                + ["--size", "40x25", "--exposure", "1.5", "--path", "legacy", "--samples", "1", "--no-skip", "-o", picture],
                check=True,
                capture_output=True,
            )
            drawn = render("room", fog="exp2", visibility=12.5, camera=(2, 1.6, 4), target=np.array([-1, 1.5, -2]),
                           set={"lights[0].attenuation.quadratic": 0.02, "lights[0].color": [1, 0.5, 0]},
                           size=(40, 25), exposure=np.float32(1.5), path="legacy", samples=1, no_skip=True)  # fmt: skip
            np.testing.assert_array_equal(drawn.shown, png_pixels(picture))
            self.assertEqual((drawn.visibility, drawn.exposure), (12.5, 1.5))
            self.assertTrue(np.ptp(drawn.shown) > 50)

    def test_light_is_linear_and_what_is_shown_is_its_srgb(self):
        drawn = render("room", visibility=20, tone="clip", glare="none", exposure=-1, **ROOM)
        self.assertEqual((drawn.light.dtype, drawn.light.shape), (np.float32, (27, 48, 3)))
        self.assertEqual((drawn.shown.dtype, drawn.shown.shape), (np.uint8, (27, 48, 3)))
        np.testing.assert_array_equal(drawn.light, self.room.light)
        light = np.clip(drawn.light.astype(float) / 2, 0, 1)
        srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        self.assertLess(np.abs(drawn.shown - 255 * srgb).max(), 1.01)  # half a step of dither, half of rounding

    def test_fog_of_the_call_is_drawn(self):
        clear = render("room", fog="none", **ROOM)
        self.assertEqual(clear.visibility, math.inf)
        self.assertEqual(self.room.visibility, 20)
        self.assertFalse(np.array_equal(clear.light, self.room.light))

    def test_threads_draw_at_once(self):
        drawn = [None] * 2

        def draw(i):
            drawn[i] = render("room", visibility=20, **ROOM)

        threads = [threading.Thread(target=draw, args=[i]) for i in range(len(drawn))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for picture in drawn:
            np.testing.assert_array_equal(picture.light, self.room.light)

    def test_child_forked_after_drawing_is_refused_with_a_sentence(self):
        child = os.fork()
        if child == 0:
            try:
                render("room", **ROOM)
            except litfog.pictures.Unsupported as refused:
                os._exit(0 if "forked from one that has drawn" in str(refused) else 1)
            finally:
                os._exit(2)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)

    def test_pictures_can_be_pickled(self):
        copy = pickle.loads(pickle.dumps(self.room))
        np.testing.assert_array_equal(copy.light, self.room.light)
        self.assertEqual(copy[2:], self.room[2:])

    def test_wrong_arguments_are_refused_with_a_sentence(self):
        for keywords, error, sentence in (
            ({"colour": 1}, TypeError, "render() got an unexpected keyword argument 'colour'"),
            ({"visibility": -5}, ValueError, "visibility = -5: must be a number >= 0"),
            ({"visibility": math.nan}, ValueError, "visibility = nan: must be a number >= 0"),
            ({"visibility": object()}, TypeError, "visibility: must be a word, a number or a sequence of numbers, is of "
                                                  "type object"),
            ({"samples": True}, TypeError, "samples: must be a word, a number or a sequence of numbers, is of type bool"),
            ({"no_skip": "yes"}, TypeError, "no_skip: must be True or False"),
            ({"fog-light": "peak"}, TypeError, "render() got an unexpected keyword argument 'fog-light'"),
            ({"fog_light": "dim"}, ValueError, "fog_light = dim: must be one of "),
            ({"size": (0, 5)}, ValueError, "size = 0x5: must be WIDTHxHEIGHT"),
            ({"camera": (1, 2)}, ValueError, "camera = 1,2: must be three numbers"),
            ({"fog": "none", "visibility": 9}, ValueError, "visibility cannot be given with fog none: the air is clear"),
            ({"rvr": 2e6}, ValueError, "rvr = 2000000: must be at most sqrt(candela / illuminance_threshold)"),
            ({"time": 3}, ValueError, "time cannot be given with room: none of its lights turns or flashes"),
            ({"set": 7}, TypeError, "set: must be a dictionary"),
            ({"set": {"lights[0].zzz": 7}}, litfog.InputError, "--set"),
        ):  # fmt: skip
            with self.subTest(keywords=keywords), self.assertRaises(error) as raised:
                render("room", **keywords)
            self.assertEqual(str(raised.exception)[: len(sentence)], sentence)
        with self.assertRaisesRegex(litfog.InputError, "^nowhere: must be a scene file or one of approach, ") as raised:
            render("nowhere")
        self.assertEqual(raised.exception.file, "nowhere")
        self.assertRaises(TypeError, render, 7)
        self.assertRaisesRegex(ValueError, "^scene: must not hold a null character$", render, "room\0")

    def test_keywords_are_the_options_of_the_command(self):
        with open(stub_file, encoding="utf-8") as file:
            stub = ast.parse(file.read())
        (function,) = [node for node in stub.body if getattr(node, "name", "") == "render"]
        keywords = {keyword.arg for keyword in function.args.kwonlyargs}
        text = subprocess.run([demo_command, "--help"], check=True, capture_output=True, text=True).stdout
        options = set(re.findall(r"^  (?:-\w,)?--([a-z0-9-]+)", text, re.MULTILINE))
        not_of_pictures = {"help", "version", "output", "frames", "reference", "heat-map", "stats", "exr", "sort-polygons"}
        self.assertLess(not_of_pictures, options)
        self.assertEqual(keywords, {option.replace("-", "_") for option in options - not_of_pictures})

    def test_names_of_scenes_and_paths_are_those_of_the_command(self):
        for what, names in (("scenes", litfog.pictures.scenes()), ("paths", litfog.pictures.paths())):
            text = subprocess.run([demo_command, "list", what], check=True, capture_output=True, text=True).stdout
            self.assertEqual(names, [line.split()[0] for line in text.splitlines()])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

# SPDX-License-Identifier: Apache-2.0
"""The C face as Python's ctypes calls it, with declarations such as a host in another language makes.

python3 ctypes_test.py <liblitfog_c.so> <light file> <litfog.h> <nm>
"""

import ctypes
import math
import re
import subprocess
import sys
from ctypes import POINTER, Structure, byref, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32, c_void_p

library, light_file, header, nm = sys.argv[1:]
litfog = ctypes.CDLL(library)

# The library exports the functions that its header declares, and no others.
symbols = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
exported = {line.split()[2].split("@")[0] for line in symbols.splitlines() if line.split()[1] != "A"}
with open(header, encoding="utf-8") as file:
    declared = set(re.findall(r"^LITFOG_API [^(]*?(litfog_\w+)\(", file.read(), re.MULTILINE))
assert declared and exported == declared, f"exported or declared alone: {sorted(exported ^ declared)}"


class Fog(Structure):
    _fields_ = [("mode", c_int32), ("density", c_double)]


class Attenuation(Structure):
    _fields_ = [("constant", c_double), ("linear", c_double), ("quadratic", c_double)]


class Cone(Structure):
    _fields_ = [("profile", c_int32)] + [(n, c_double) for n in ("half_angle", "exponent", "inner", "outer")]


class Light(Structure):
    _fields_ = [("color", c_double * 3), ("attenuation", Attenuation), ("threshold", c_double), ("cone", Cone),
                ("density_scale", c_double)]


class PlacedLight(Structure):
    _fields_ = [("light", Light), ("position", c_double * 3), ("direction", c_double * 3), ("carried", c_int32)]


class Intensity(Structure):
    _fields_ = [("intensity", c_double), ("peak_range", c_double), ("extent", c_double), ("status", c_int32)]


class EyeRay(Structure):
    _fields_ = [("origin", c_double * 3), ("direction", c_double * 3), ("length", c_double)]


class BatchLights(Structure):
    _fields_ = [("count", c_size_t), ("constant", POINTER(c_double)), ("linear", POINTER(c_double)),
                ("quadratic", POINTER(c_double)), ("threshold", POINTER(c_double)), ("threshold_count", c_size_t),
                ("density", POINTER(c_double)), ("density_count", c_size_t)]


class BatchSolutions(Structure):
    _fields_ = [("intensity", POINTER(c_double)), ("peak_range", POINTER(c_double)), ("extent", POINTER(c_double)),
                ("status", c_char_p)]


class Handle(Structure):
    _fields_ = [("slot", c_uint32), ("generation", c_uint32)]


class Range(Structure):
    _fields_ = [("begin", c_size_t), ("end", c_size_t)]


class Changes(Structure):
    _fields_ = [("kinds", POINTER(Range)), ("kind_count", c_size_t), ("instances", POINTER(Range)),
                ("instance_count", c_size_t)]


class Kind(Structure):
    _fields_ = [("attenuation_extent", c_float * 4), ("cone_scale_intensity", c_float * 4)]


class Tables(Structure):
    _fields_ = [("kinds", POINTER(Kind)), ("kind_count", c_size_t), ("instances", c_void_p),
                ("instance_count", c_size_t)]


class ShaderText(Structure):
    _fields_ = [("name", c_char_p), ("text", c_char_p)]


litfog.litfog_last_error.restype = c_char_p
litfog.litfog_updater_destroy.argtypes = [c_void_p]


def call(name, *arguments):
    if getattr(litfog, name)(*arguments) != 0:
        raise ValueError(litfog.litfog_last_error().decode())


# A light file, solved.
light, name = Light(), ctypes.create_string_buffer(64)
call("litfog_read_light", light_file.encode(), byref(light), name, c_size_t(64))
assert name.value == b"a lamp" and light.attenuation.quadratic == 0.25 and light.threshold == 0.05

fog = Fog()
call("litfog_fog_from_visibility", c_int32(0), c_double(50), c_double(0.05), byref(fog))
assert math.isclose(fog.density, -math.log(0.05) / 50)
solved = Intensity()
call("litfog_solve", byref(light), byref(fog), byref(solved))
sampled = max(-math.expm1(-fog.density * r) / (1 + 0.25 * r * r) for r in (i * 1e-3 for i in range(1, 8700)))
assert math.isclose(solved.intensity, sampled, rel_tol=1e-6) and math.isclose(solved.extent, math.sqrt(19 / 0.25))

# Errors.
try:
    call("litfog_fog_from_visibility", c_int32(0), c_double(math.nan), c_double(0.05), byref(fog))
    raise AssertionError("NaN is taken")
except ValueError as error:
    assert str(error) == "visibility = nan: must be >= 0", error

# Columns.
column = lambda *values: (c_double * len(values))(*values)
intensities = column(0, 0)
batch = BatchLights(2, column(1, 1), column(0, 0), column(0.25, 0.01), column(0.05), 1, column(fog.density), 1)
call("litfog_solve_batch", c_int32(0), byref(batch), byref(BatchSolutions(intensities)), None)
assert math.isclose(intensities[0], solved.intensity, rel_tol=1e-14) and intensities[1] > intensities[0]

# Airlight along a ray.
placed, airlight = PlacedLight(), c_double()
call("litfog_default_placed_light", byref(placed))
placed.light, placed.position, placed.carried = light, (0, 3, -20), 1
ray = EyeRay((0, 0, 0), (0, 0, -1), math.inf)
call("litfog_airlight", byref(placed), byref(fog), byref(ray), c_size_t(1), None, byref(airlight))
assert 0 < airlight.value < 1

# The updater's tables.
updater, handle, changes, tables = c_void_p(), Handle(), Changes(), Tables()
call("litfog_updater_create", c_double(0.5), byref(updater))
call("litfog_updater_add", updater, byref(placed), byref(handle))
call("litfog_updater_set_fog", updater, byref(fog), byref(changes))
assert (changes.kind_count, changes.kinds[0].begin, changes.kinds[0].end) == (1, 0, 1)
call("litfog_updater_tables", updater, byref(tables))
assert math.isclose(tables.kinds[0].cone_scale_intensity[3], solved.intensity, rel_tol=1e-6)
call("litfog_updater_remove", updater, handle)
litfog.litfog_updater_destroy(updater)

# Shaders.
texts, count, length = POINTER(ShaderText)(), c_size_t(), c_size_t()
call("litfog_shader_texts", byref(texts), byref(count))
assert {texts[i].name for i in range(count.value)} >= {b"litfog/shaders/fog.glsl", b"litfog/shaders/glow.glsl"}
source = b'#include "litfog/shaders/glow.glsl"\n'
call("litfog_expand_shader", source, None, c_size_t(0), byref(length))
expanded = ctypes.create_string_buffer(length.value + 1)
call("litfog_expand_shader", source, expanded, c_size_t(length.value + 1), byref(length))
assert b"vec3 litfog_glow(" in expanded.value and b"#include" not in expanded.value

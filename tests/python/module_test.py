# SPDX-License-Identifier: Apache-2.0
"""`import litfog` beside the command litfog-solve, which calls the same C++ without Python.

module_test.py <litfog-solve> <data folder> <tests/data folder> <litfog.pyi>
"""

import ast
import copy
import json
import math
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import tracemalloc
import unittest
import zipfile

import litfog
import numpy as np

solve_command, data, test_data, stub_file = sys.argv[1:5]


def random_columns(count, dtype):
    """Attenuations of lights of 5 m to 5,000 m and densities of 50 m to 10,000 m of visibility, by a fixed seed."""
    random = np.random.default_rng(7)
    extent = 10 ** random.uniform(0.7, 3.7, count)
    return [
        column.astype(dtype)
        for column in (
            random.uniform(0.2, 2, count),
            random.uniform(0, 10, count) / extent,
            random.uniform(0, 10, count) / extent**2 + 1e-9,
            3 / 10 ** random.uniform(1.7, 4, count),
        )
    ]


def address(array):
    return array.__array_interface__["data"][0]


def allocated_by(call):
    """The most bytes that Python and NumPy held during a call, over what they held before."""
    tracemalloc.start()
    try:
        call()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


class SolveTest(unittest.TestCase):
    def test_solutions_are_those_of_the_command_to_the_bit(self):
        lamp_file = os.path.join(data, "lights", "landing-lamp.json")
        for mode in (litfog.FogMode.exp, litfog.FogMode.exp2):
            output = subprocess.run(
                [solve_command, "--light", lamp_file, "--fog", mode.name, "--visibility", "50,400,1500,inf"]
                + ["--format", "json"],
                check=True,
                capture_output=True,
                text=True,
            ).stdout
            lamp = litfog.read_light(lamp_file)
            for row in json.loads(output):
                fog = litfog.Fog.from_visibility(mode, float(row["visibility_m"]))
                solved = litfog.solve_fog_intensity(lamp, fog)
                self.assertEqual(
                    (fog.density, solved.intensity, solved.peak_range, solved.extent, litfog.axial_airlight(lamp, fog)),
                    (row["density"], row["intensity"], row["peak_range"], row["extent"], row["airlight"]),
                )
                self.assertEqual(litfog.solve_fog_intensity(lamp.attenuation, fog, lamp.threshold).intensity, row["intensity"])

    def test_wrong_values_raise_field_value_and_rule(self):
        with self.assertRaisesRegex(ValueError, r"^attenuation\.linear = -1: must be finite and >= 0$"):
            litfog.solve_fog_intensity(litfog.Attenuation(linear=-1), litfog.Fog(density=1))
        with self.assertRaisesRegex(ValueError, "^visibility = nan: must be >= 0$"):
            litfog.Fog.from_visibility(litfog.FogMode.exp, math.nan)

    def test_values_are_read_back_from_repr_and_pickle(self):
        light = litfog.Light("a", (1, 0.5, 0), litfog.Attenuation(0.5, 0.1, 2), 0.1, litfog.Cone.cosine(0.3, 7), 0.4)
        placed = litfog.PlacedLight(light, (1, 2, 3), (1, 0, 0), True)
        for value in (placed, litfog.Fog(litfog.FogMode.exp2, 0.25), litfog.Atmosphere(litfog.Fog(density=1), litfog.Phase.henyey_greenstein(0.5), top=7),
                      litfog.FogLayer(1, 9, 2, 50), litfog.Atmosphere(top=7, profile=litfog.DensityProfile([(1, 0.5)]))):  # fmt: skip
            self.assertEqual(repr(eval(repr(value))), repr(value))
            self.assertEqual(repr(pickle.loads(pickle.dumps(value))), repr(value))
            self.assertEqual(repr(copy.deepcopy(value)), repr(value))
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                self.assertEqual(pickle.loads(pickle.dumps(value, protocol)), value)
        self.assertEqual(placed.light.color, (1, 0.5, 0))
        self.assertEqual(pickle.loads(pickle.dumps(litfog.FogMode.exp2, 0)), litfog.FogMode.exp2)

    def test_records_are_equal_where_all_their_fields_are(self):
        values = {"name": "a", "color": (1, 0.5, 0), "attenuation": litfog.Attenuation(0.5, 0.1, 2), "threshold": 0.1,
                  "cone": litfog.Cone.cosine(0.3, 7), "density_scale": 0.4, "flash": litfog.Flash(1, [(0, 0.5, 2)])}  # fmt: skip
        light = litfog.Light(**values)
        self.assertEqual(light, litfog.Light(**values))
        self.assertFalse(light != litfog.Light(**values))
        for field in values:
            other = light.replace(**{field: getattr(litfog.Light(), field)})
            self.assertNotEqual(light, other, field)
            self.assertEqual(other.replace(**{field: values[field]}), light)
        self.assertEqual(litfog.PlacedLight(light), litfog.PlacedLight(litfog.Light(**values)))
        self.assertNotEqual(litfog.PlacedLight(light), litfog.PlacedLight(light, carried=True))
        self.assertNotEqual(litfog.Fog(), litfog.Attenuation())
        self.assertNotEqual(litfog.Fog(), None)
        self.assertEqual(len({light, litfog.Light(**values), litfog.Light()}), 2)
        self.assertEqual(len({litfog.DensityProfile([(0, 1), (1, 0)]), litfog.DensityProfile(((0, 1.0), (1, 0)))}), 1)

    def test_records_cannot_become_wrong(self):
        light = litfog.Light("a", attenuation=litfog.Attenuation(1, 0, 0.25), source_radius=1)
        air = litfog.Atmosphere(litfog.Fog(density=1), profile=litfog.DensityProfile([(0, 1), (1, 0)]))
        records = (air, air.fog, air.phase, air.phase.first, air.profile, litfog.FogLayer(), light, light.attenuation,
                   litfog.Cone.cosine(0.3, 7), litfog.Flash(1, [(0, 0.5, 2)]), litfog.PlacedLight(light))  # fmt: skip
        for record in records:
            self.assertEqual(record.replace(), record)
            for field in [name for name, of in vars(type(record)).items() if isinstance(of, property)]:
                self.assertRaises(AttributeError, setattr, record, field, getattr(record, field))
        for record, field, value, message in (
            (light, "threshold", -1, r"threshold = -1: must be in \(0, 1\)"),
            (light, "source_radius", 3, "source_radius = 3: must be "),
            (light.attenuation, "linear", -1, r"attenuation\.linear = -1: must be finite and >= 0"),
            (air, "albedo", 2, r"albedo = 2: must be in \[0, 1\]"),
            (air, "fog", litfog.Fog("exp2"), r"profile\.count = 2: must be 0 in exp2 fog"),
            (air.profile, "knots", [(1, 0), (1, 1)], r"profile\.knots\[1\]\.height = 1: must be above the knot before"),
            (records[8], "exponent", -1, r"cone\.exponent = -1: must be "),
            (records[9], "period", 0.1, r"flash\."),
            (records[10], "direction", (0, 0, 2), "direction = 2: length must be 1"),
        ):
            before = repr(record)
            self.assertRaisesRegex(ValueError, "^" + message, record.replace, **{field: value})
            self.assertEqual(repr(record), before)
        self.assertRaisesRegex(TypeError, "^litfog.Light has no field thresold$", light.replace, thresold=0.1)

    def test_instances_without_a_value_cannot_be_made(self):
        classes = [value for value in vars(litfog).values() if isinstance(value, type) and "__doc__" in vars(value)]
        classes = [value for value in classes if "pybind11" in type(value).__name__]
        self.assertGreater(len(classes), 20)
        for made in classes:
            self.assertRaises(TypeError, made.__new__, made)
        for result in (litfog.FogUpdater(), litfog.FogUpdater().set_fog(litfog.Fog())):
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.assertRaisesRegex(TypeError, "^cannot pickle a litfog.(FogUpdater|FogLightChanges)$"):
                    pickle.dumps(result, protocol)

    def test_base_of_all_classes_makes_no_instance(self):
        base = litfog.Light.__base__
        for made in (base, type("Derived", (base,), {})):
            self.assertRaisesRegex(TypeError, "^cannot create '.*' instances$", made)
            self.assertRaises(TypeError, base.__new__, made)
        self.assertEqual(litfog.Light("a").name, "a")

    def test_enumerations_take_their_own_values_alone(self):
        enumerations = [value for value in vars(litfog).values() if hasattr(value, "__members__")]
        self.assertGreaterEqual(len(enumerations), 9)
        for enumeration in enumerations:
            values = [int(member) for member in enumeration.__members__.values()]
            for member in enumeration.__members__.values():
                self.assertIs(enumeration(int(member)), member)
                self.assertIs(enumeration(member), member)
                self.assertTrue(enumeration is litfog.BatchStatus or enumeration(member.name) is member)
                for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                    self.assertIs(pickle.loads(pickle.dumps(member, protocol)), member)
            for wrong in (max(values) + 1, 99, -1, 2**70):
                self.assertRaises(ValueError, enumeration, wrong)
        with self.assertRaisesRegex(ValueError, r"^litfog.FogMode = 99: must be one of 0 \(exp\), 1 \(exp2\)$"):
            litfog.FogMode(99)
        for wrong in ("fog", 1.0, None):
            self.assertRaises((TypeError, ValueError), litfog.FogMode, wrong)
        exp = litfog.FogMode.exp
        for method in ("__init__", "__setstate__"):
            getattr(exp, method, lambda value: None)(1)
        self.assertEqual((int(exp), exp), (0, litfog.FogMode(0)))

    def test_enumerators_are_taken_by_their_names(self):
        fog = litfog.Fog("exp2", 0.5)
        self.assertEqual(fog, litfog.Fog(litfog.FogMode.exp2, 0.5))
        self.assertEqual(fog.replace(mode="exp").mode, litfog.FogMode.exp)
        self.assertEqual(litfog.density_from_visibility("exp", 400), litfog.Fog.from_visibility("exp", 400).density)
        self.assertEqual(litfog.fit_attenuation(extent=10, family="linear").attenuation.quadratic, 0)
        for call in (lambda: litfog.Fog("ex"), lambda: fog.replace(mode="ex"), lambda: litfog.FogMode("ex")):
            self.assertRaisesRegex(ValueError, r"^litfog.FogMode = 'ex': must be \"exp\" or \"exp2\"$", call)

    def test_bundled_lights_are_read_by_their_names(self):
        self.assertTrue((litfog.data_dir / "scenes").is_dir())
        for file in (litfog.data_dir / "lights").glob("*.json"):
            self.assertEqual(litfog.read_light(file.stem), litfog.read_light(file))
        with self.assertRaisesRegex(litfog.InputError, "^landing-lmp: .* a bundled light; did you mean landing-lamp\\?$"):
            litfog.read_light("landing-lmp")
        with self.assertRaisesRegex(litfog.InputError, "^landing-lamp.json: cannot be read"):
            litfog.read_light("landing-lamp.json")

    def test_every_class_has_a_repr_of_its_own(self):
        for value in vars(litfog).values():
            if isinstance(value, type):
                self.assertIsNot(value.__repr__, object.__repr__, value)
        updater = litfog.FogUpdater()
        handle = updater.add(litfog.PlacedLight(litfog.Light()))
        updater.set_fog(litfog.Fog())
        self.assertEqual(repr(updater), "<litfog.FogUpdater: 1 instances of 1 kinds>")
        self.assertEqual(repr(handle), "<litfog.FogLightHandle: light 0, generation 1>")
        lamp = litfog.read_luminaire(os.path.join(test_data, "photometry", "landing_lamp.ies"))
        self.assertEqual(repr(lamp.distribution), "<litfog.IntensityDistribution: type=litfog.PhotometryType.c, "
                                                  "1 horizontal and 13 vertical angles>")  # fmt: skip

    def test_another_python_is_told_for_which_litfog_is_built(self):
        package = os.path.dirname(litfog.__file__)
        with tempfile.TemporaryDirectory() as folder:
            copied = os.path.join(folder, "litfog")
            os.mkdir(copied)
            shutil.copy(os.path.join(package, "__init__.py"), copied)
            open(os.path.join(copied, "_litfog.cpython-34-riscv64-linux-gnu.so"), "wb").close()
            run = subprocess.run([sys.executable, "-c", "import litfog"], env={**os.environ, "PYTHONPATH": folder},
                                 capture_output=True, text=True)  # fmt: skip
        self.assertRegex(run.stderr.splitlines()[-1], "^ImportError: litfog in .* is built for cpython-34-riscv64-linux-gnu"
                                                      ", and this Python is cpython-3[^ ]*: use the other, or build")  # fmt: skip

    def test_results_show_their_fields(self):
        fit = litfog.fit_attenuation(extent=10)
        self.assertEqual(repr(fit), f"<litfog.AttenuationFit: attenuation={fit.attenuation}, threshold=0.05, "
                                    "status=litfog.AttenuationFitStatus.optimal, rms_error=0.0, largest_error=0.0>")  # fmt: skip
        changes = litfog.FogUpdater().set_fog(litfog.Fog())
        self.assertEqual(repr(changes), "<litfog.FogLightChanges: kinds=[], instances=[], sources=[]>")
        cone = litfog.fit_cone(angles=[0, 0.1, 0.2], intensities=[3, 2, 1])
        self.assertIn(f"profiles={cone.profiles}, best_index={cone.best_index}>", repr(cone))

    def test_source_of_a_light_is_a_line_or_several(self):
        light = litfog.Light("a")
        self.assertEqual(litfog.format_light(light, "b"), litfog.format_light(light, source=["b"]))
        self.assertIn('"b",', litfog.format_light(light, ("b", "c")))

    def test_classes_can_be_derived_from(self):
        class Named(litfog.Fog):
            def __init__(self, name):
                super().__init__(density=0.25)
                self.name = name

        self.assertEqual((Named("a").density, Named("a").name), (0.25, "a"))

    def test_functions_of_range_take_numbers_and_arrays(self):
        attenuation, fog = litfog.Attenuation(1, 0, 0.25), litfog.Fog(density=0.5)
        ranges = np.array([[0.0, 2.0], [4.0, math.inf]])
        self.assertEqual(litfog.attenuation_at(attenuation, 2.0), 0.5)
        np.testing.assert_array_equal(litfog.attenuation_at(attenuation, ranges), [[1, 0.5], [0.2, 0]])
        np.testing.assert_allclose(litfog.opacity_at(fog, ranges), -np.expm1(-0.5 * ranges), rtol=1e-15)
        np.testing.assert_allclose(litfog.fog_factor_at(fog, ranges), np.exp(-0.5 * ranges), atol=3e-16)
        self.assertEqual(litfog.cone_at(litfog.Cone.cosine(1, 2), 0.75), 0.5625)
        cosines, weights = np.polynomial.legendre.leggauss(100)
        phase = litfog.Phase.henyey_greenstein(0.5)
        np.testing.assert_allclose(weights @ litfog.phase_at(phase, cosines), 2, rtol=1e-13)
        self.assertEqual(litfog.phase_at(litfog.Phase(), -1), 1)
        self.assertAlmostEqual(litfog.visibility(litfog.Fog.from_visibility("exp2", 150, 0.02), 0.02), 150)

    def test_reference_airlight_is_airlight_more_exactly(self):
        air = litfog.Atmosphere(litfog.Fog(density=0.05), litfog.Phase.droplets(10))
        light = litfog.Light(attenuation=litfog.Attenuation(1, 0, 1), threshold=1e-6)
        lamp = litfog.PlacedLight(light, position=(0, 1, -9))
        rays = [((0, 0, 0), (0, 0, -1), length) for length in (5, math.inf)]
        exact = litfog.reference_airlight(lamp, air, rays)
        np.testing.assert_allclose(litfog.airlight(lamp, air, rays), exact, rtol=0.02)
        middles = (np.arange(200_000) + 0.5) / 200_000 * 5  # the first ray's
        ranges = np.hypot(1, 9 - middles)
        scattered = litfog.phase_at(air.phase, (9 - middles) / ranges)
        arriving = litfog.attenuation_at(light.attenuation, ranges) * np.exp(-0.05 * (ranges + middles))
        self.assertAlmostEqual(exact[0], np.sum(scattered * arriving) * 0.05 * 5 / 200_000, delta=1e-9 * exact[0])
        wrong = [((0, 0, 0), (0, 0, -1), 5), ((0, 0, 0), (0, 0, -2), 5)]
        message = r"^rays\[1\]\.direction = 2: length must be 1 within 1e-6$"
        for function in (litfog.airlight, litfog.reference_airlight):
            self.assertRaisesRegex(ValueError, message, function, lamp, air, wrong)

    def test_numbers_lists_tuples_and_arrays_are_taken_alike(self):
        attenuation, fog, cone = litfog.Attenuation(1, 0, 0.25), litfog.Fog(density=0.5), litfog.Cone.cosine(1.5, 2)
        for function in (
            lambda x: litfog.attenuation_at(attenuation, x),
            lambda x: litfog.fog_factor_at(fog, x),
            lambda x: litfog.opacity_at(fog, x),
            lambda x: litfog.cone_at(cone, x),
            lambda x: litfog.flash_at(litfog.Flash(1, [(0.1, 0.3, 2)]), x),
            lambda x: litfog.density_from_visibility("exp", x),
            lambda x: litfog.compute_extent(attenuation, x),
            lambda x: litfog.flux_within(cone, x),
            lambda x: litfog.angle_at_level(cone, x),
            lambda x: litfog.illuminance_threshold(x),
            lambda x: litfog.runway_visual_range(fog, x),
            lambda x: litfog.runway_visual_range(fog, 1000, x),
            lambda x: litfog.effective_intensity(attenuation, x),
            lambda x: litfog.light_reach(litfog.Light(), fog, x),
            lambda x: litfog.reach_budget(0.1, 9, x, litfog.Atmosphere(fog)),
            lambda x: litfog.directional_fog_factor(litfog.Atmosphere(fog, top=3), (0, 1, 0), x),
            lambda x: np.asarray(litfog.color_of_temperature(np.multiply(x, 10_000)))[..., 2],
            lambda x: np.asarray(litfog.solve_fog_intensities(1, x, 0.25, 0.5).intensity).reshape(np.shape(x)),
            lambda x: np.asarray(litfog.solve_fog_intensities(1, 0, 0.25, 0.5, x).extent).reshape(np.shape(x)),
        ):
            single = [float(function(x)) for x in (0.25, 0.5)]
            self.assertNotEqual(*single)
            for both in ([0.25, 0.5], (0.25, 0.5), np.array([0.25, 0.5]), np.array([0.25, 7, 0.5])[::2],
                         np.array([0.25, 0.5], np.float16)):  # fmt: skip
                np.testing.assert_array_equal(function(both), single)
            self.assertEqual(float(function(np.float64(0.25))), single[0])
            self.assertEqual(np.shape(function([0.25])), (1,))
        ray = ((0, 0, 0), [0, 0, -1], 5)
        placed = litfog.PlacedLight(litfog.Light(), [0, 3, -9])
        rays = np.array([ray, ray], litfog.EYE_RAY)
        single = litfog.airlight(placed, litfog.Atmosphere(fog), ray)
        self.assertIs(type(single), float)
        self.assertEqual(litfog.airlight(placed, litfog.Atmosphere(fog), rays[0]), single)
        for both in (rays, [ray, ray], np.array([ray] * 4, litfog.EYE_RAY)[::2]):
            np.testing.assert_array_equal(litfog.airlight(placed, litfog.Atmosphere(fog), both), [single, single])
        for wrong in (5, [ray, 5], ray[:2], ((0, 0), (0, 0, -1), 5)):
            with self.assertRaisesRegex(TypeError, "^rays: must be an array of EYE_RAY, or tuples of an origin"):
                litfog.airlight(placed, litfog.Atmosphere(fog), wrong)

    def test_bundled_lights_are_taken_by_their_names_wherever_lights_are(self):
        lamp, fog = litfog.read_light("landing-lamp"), litfog.Fog("exp", 0.01)
        placed = litfog.PlacedLight("landing-lamp", (0, 1, 0))
        self.assertEqual(placed, litfog.PlacedLight(lamp, (0, 1, 0)))
        self.assertEqual(placed.replace(light="headlight").light, litfog.read_light("headlight"))
        for function in (litfog.solve_fog_intensity, litfog.axial_airlight, lambda of, fog: litfog.light_reach(of, fog, 0.01),
                         lambda of, fog: litfog.candela(of), lambda of, fog: litfog.photometric(of)):  # fmt: skip
            self.assertEqual(function("landing-lamp", fog), function(lamp, fog))
        with self.assertRaisesRegex(litfog.InputError, "^landing-lmap: must be a file or a bundled light; did you mean"):
            litfog.PlacedLight("landing-lmap")

    def test_wrong_arguments_are_answered_in_one_sentence(self):
        masked = np.ma.masked
        for call, error, message in (
            (lambda: litfog.Fog(density=masked), ValueError, "density: must hold no masked values"),
            (lambda: litfog.Fog.from_visibility("exp", masked), ValueError, "metres: must hold no masked values"),
            (lambda: litfog.Cone.cosine(masked, 2), ValueError, "number: must hold no masked values"),
            (lambda: litfog.PlacedLight(litfog.Light(), (0, masked, 0)), ValueError, "position: must hold no masked values"),
            (lambda: litfog.Fog.from_visibility("exp3", 400), ValueError, "litfog.FogMode = 'exp3': must be \"exp\" or \"exp2\"$"),
            (lambda: litfog.Fog.from_visibility("exp", [400, 500]), TypeError, "metres: must be float, is list$"),
            (lambda: litfog.Fog(density="a"), TypeError, "density: must be float, is str$"),
            (lambda: litfog.Atmosphere(5), TypeError, "fog: must be Fog, is int$"),
            (lambda: litfog.PlacedLight(None), TypeError, "light: must be Light, is NoneType$"),
        ):  # fmt: skip
            self.assertRaisesRegex(error, "^" + message, call)
        self.assertRaisesRegex(TypeError, "^mode: must be FogMode, is float$", litfog.Fog().replace, mode=0.5)

    def test_import_without_numpy_says_that_it_is_needed(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "numpy"))
            with open(os.path.join(folder, "numpy", "__init__.py"), "w") as file:
                file.write("raise ModuleNotFoundError('No module named numpy')")
            path = os.pathsep.join([folder, os.path.dirname(os.path.dirname(litfog.__file__))])
            run = subprocess.run([sys.executable, "-c", "import litfog"], env={**os.environ, "PYTHONPATH": path},
                                 capture_output=True, text=True)  # fmt: skip
        self.assertRegex(run.stderr.splitlines()[-1], "^ImportError: litfog needs NumPy")

    def test_values_that_mean_something_else_are_refused(self):
        def masked(values, dtype=np.float64):
            return np.ma.array(values, dtype, mask=[False] * (len(values) - 1) + [True])

        class Metres(np.ndarray):
            unit = "km"

        rows = np.ones(3)
        rays = np.ma.zeros(2, litfog.EYE_RAY)
        rays.mask["length"] = [False, True]
        placed = litfog.PlacedLight(litfog.Light())
        calls = {
            "range": [
                lambda x: litfog.attenuation_at(litfog.Attenuation(), x),
                lambda x: litfog.fog_factor_at(litfog.Fog(), x),
                lambda x: litfog.opacity_at(litfog.Fog(), x),
            ],
            "cos_angle": [lambda x: litfog.cone_at(litfog.Cone.cosine(1, 2), x)],
            "metres": [lambda x: litfog.density_from_visibility(litfog.FogMode.exp, x)],
            "ranges": [lambda x: litfog.fit_attenuation(ranges=x, attenuations=[0.9, 0.5, 0.1])],
            "attenuations": [lambda x: litfog.fit_attenuation(ranges=[1, 2, 3], attenuations=x)],
            "weights": [
                lambda x: litfog.fit_attenuation(ranges=[1, 2, 3], attenuations=[0.9, 0.5, 0.1], weights=x),
                lambda x: litfog.fit_cone(angles=[0, 0.1, 0.2], intensities=[3, 2, 1], weights=x),
            ],
            "angles": [lambda x: litfog.fit_cone(angles=x, intensities=[3, 2, 1])],
            "intensities": [lambda x: litfog.fit_cone(angles=[0, 0.1, 0.2], intensities=x)],
            "constant": [lambda x: litfog.solve_fog_intensities(x, rows, rows, 0.1)],
            "density": [lambda x: litfog.solve_fog_intensities(rows, rows, rows, x)],
            "threshold": [lambda x: litfog.solve_fog_intensities(rows, rows, rows, 0.1, x)],
            "out.intensity": [
                lambda x: litfog.solve_fog_intensities(rows, rows, rows, 0.1, out=litfog.BatchSolutions(intensity=x))
            ],
            "position": [lambda x: litfog.PlacedLight(litfog.Light(), position=x)],
            "to_light": [lambda x: litfog.directional_fog_factor(litfog.Atmosphere(), x, 1)],
        }
        for name, functions in calls.items():
            for function in functions:
                with self.assertRaisesRegex(ValueError, f"^{name}: must hold no masked values"):
                    function(masked([0.9, 0.5, 0.1]))
                with self.assertRaisesRegex(TypeError, f"^{name}: must be plain numbers, has the unit km$"):
                    function(np.array([0.9, 0.5, 0.1]).view(Metres))
                for wrong in (["a", "b", "c"], [1j, 2, 3], [None, 1, 2], ["2020-01-01"] * 3):
                    for dtype in (None, object):
                        self.assertRaises(TypeError, function, np.array(wrong, dtype))
                self.assertRaises(TypeError, function, np.array(["2020-01-01"] * 3, "M8[D]"))
                self.assertRaises(TypeError, function, np.array([1, 2, 3], "m8[s]"))
        with self.assertRaisesRegex(ValueError, "^rays: must hold no masked values"):
            litfog.airlight(placed, litfog.Atmosphere(), rays)
        with self.assertRaisesRegex(ValueError, "^range: must hold no masked values"):
            litfog.attenuation_at(litfog.Attenuation(), [masked([1, 2]), [3, 4]])
        with self.assertRaisesRegex(ValueError, "^range: must hold no masked values"):
            litfog.attenuation_at(litfog.Attenuation(), np.ma.masked)
        # One that masks nothing is an array like any other.
        whole = np.ma.array([0.0, 2.0])
        np.testing.assert_array_equal(litfog.attenuation_at(litfog.Attenuation(1, 0, 0.25), whole), [1, 0.5])
        for plain in ([0, 2], (0, 2), np.array([0, 2], np.uint8), np.array([0, 2], np.float16)):
            np.testing.assert_array_equal(litfog.attenuation_at(litfog.Attenuation(1, 0, 0.25), plain), [1, 0.5])

    def test_short_memory_is_a_memory_error(self):
        with tempfile.TemporaryDirectory() as folder:
            large = os.path.join(folder, "large.ies")
            with open(large, "wb") as file:
                file.write(b"IESNA:LM-63-2002\n" + b" " * (60 << 20))
            script = (
                "import litfog, resource, sys\n"
                "pages = int(open('/proc/self/statm').read().split()[0])\n"
                "limit = pages * resource.getpagesize() + (16 << 20)\n"
                "resource.setrlimit(resource.RLIMIT_AS, (limit, limit))\n"
                "try:\n    litfog.read_luminaire(sys.argv[1])\n"
                "except MemoryError:\n    sys.exit(7)\n"
            )
            self.assertEqual(subprocess.run([sys.executable, "-c", script, large]).returncode, 7)

    def test_runway_visual_range_goes_both_ways(self):
        fog = litfog.Fog.from_runway_visual_range(litfog.FogMode.exp, 550)
        self.assertAlmostEqual(math.log(20) / fog.density, 155, delta=0.5)
        self.assertAlmostEqual(litfog.runway_visual_range(fog), 550, delta=1e-9)
        by_day = {"candela": 5000, "illuminance_threshold": litfog.illuminance_threshold(1000)}
        fog = litfog.Fog.from_runway_visual_range(litfog.FogMode.exp2, 300, **by_day)
        self.assertAlmostEqual(litfog.runway_visual_range(fog, **by_day), 300, delta=1e-9)
        self.assertEqual(litfog.runway_visual_range(litfog.Fog()), math.inf)
        with self.assertRaisesRegex(ValueError, r"^runway_visual_range = 1001: must be at most sqrt\("):
            litfog.Fog.from_runway_visual_range(litfog.FogMode.exp, 1001, 100, 1e-4)
        with self.assertRaisesRegex(ValueError, "^candela = -1: must be finite and >= 0$"):
            litfog.runway_visual_range(fog, -1)
        with self.assertRaisesRegex(ValueError, "^background = nan: must be in \[0, 1e12\]$"):
            litfog.illuminance_threshold(math.nan)

    def test_densities_of_arrays_are_those_of_single_fogs(self):
        metres = np.array([[0.0, 50, 400], [1500, 1e4, math.inf]])
        for mode in (litfog.FogMode.exp, litfog.FogMode.exp2):
            densities = litfog.density_from_visibility(mode, metres, 0.02)
            for i, visibility in np.ndenumerate(metres):
                self.assertEqual(densities[i], litfog.Fog.from_visibility(mode, visibility, 0.02).density)
            self.assertEqual(
                litfog.density_from_visibility(mode, 300), litfog.Fog.from_visibility(mode, 300).density
            )
        self.assertEqual((densities[0, 0], densities[1, 2]), (math.inf, 0))
        with self.assertRaisesRegex(ValueError, "^visibility = -1: must be >= 0$"):
            litfog.density_from_visibility(litfog.FogMode.exp, [400, -1])
        with self.assertRaisesRegex(ValueError, r"^contrast = 1: must be in \(0, 1\)$"):
            litfog.density_from_visibility(litfog.FogMode.exp, 400, 1)


class BatchTest(unittest.TestCase):
    def test_columns_of_both_precisions_are_solved_as_single_lights_are(self):
        for dtype, largest in ((np.float64, 4e-16 * 2), (np.float32, 2.5e-7)):
            constant, linear, quadratic, density = random_columns(1000, dtype)
            solved = litfog.solve_fog_intensities(constant, linear, quadratic, density)
            self.assertEqual((solved.intensity.dtype, solved.status.dtype), (dtype, np.uint8))
            self.assertEqual((solved.invalid_count, solved.status.max()), (0, int(litfog.BatchStatus.ok)))
            for i in range(0, 1000, 37):
                single = litfog.solve_fog_intensity(
                    litfog.Attenuation(constant[i], linear[i], quadratic[i]), litfog.Fog(density=density[i])
                )
                self.assertLessEqual(abs(solved.intensity[i] - single.intensity), largest * single.intensity)
                self.assertLessEqual(abs(solved.extent[i] - single.extent), largest * single.extent)

    def test_results_are_written_where_out_lies_and_nowhere_else(self):
        constant, linear, quadratic, density = random_columns(100, np.float64)
        whole = litfog.solve_fog_intensities(constant, linear, quadratic, density)
        table = np.zeros((3, 100))
        out = litfog.BatchSolutions(intensity=table[1])
        before = address(out.intensity)
        self.assertIs(litfog.solve_fog_intensities(constant, linear, quadratic, density, out=out), out)
        self.assertEqual((address(out.intensity), out.intensity.base is table), (before, True))
        np.testing.assert_array_equal(table, [np.zeros(100), whole.intensity, np.zeros(100)])
        self.assertIsNone(out.extent)

    def test_lights_are_read_where_they_lie(self):
        # NumPy tells tracemalloc what it allocates; a copy of one column would be 800,000 bytes.
        count = 100_000
        for dtype in (np.float64, np.float32):
            columns = random_columns(count, dtype)
            out = litfog.BatchSolutions(intensity=np.zeros(count, dtype))
            self.assertLess(allocated_by(lambda: litfog.solve_fog_intensities(*columns, out=out)), 10_000)
            self.assertGreater(allocated_by(lambda: litfog.solve_fog_intensities(*columns)), 3 * out.intensity.nbytes)

    def test_invalid_lights_are_counted_and_marked(self):
        solved = litfog.solve_fog_intensities(np.array([1.0, -1.0]), np.zeros(2), np.ones(2), 0.01)
        self.assertEqual((solved.invalid_count, list(solved.status)), (1, [0, int(litfog.BatchStatus.invalid)]))
        self.assertEqual(list(solved.status == litfog.BatchStatus.invalid), [False, True])
        self.assertEqual(solved.intensity[1], 0)

    def test_modes_and_single_values_reach_the_solver(self):
        one = np.ones(1)
        solved = litfog.solve_fog_intensities(one, 0 * one, 0.25 * one, 0.125, 0.5, litfog.FogMode.exp2)
        single = litfog.solve_fog_intensity(litfog.Attenuation(1, 0, 0.25), litfog.Fog(litfog.FogMode.exp2, 0.125), 0.5)
        self.assertAlmostEqual(solved.intensity[0], single.intensity, 14)
        self.assertEqual(solved.extent[0], single.extent)

    def test_columns_that_do_not_fit_are_refused_with_a_sentence(self):
        ones = np.ones(4)
        read_only = np.zeros(4)
        read_only.flags.writeable = False
        unaligned = np.zeros(33, np.uint8)[1:].view(np.float64)
        for columns, error, sentence in (
            (([1.0], ones, ones, 1), ValueError, "linear: must have 1 values, has 4"),
            ((ones, ones[:3], ones, 1), ValueError, "linear: must have 4 values, has 3"),
            ((np.ones((2, 2)), ones, ones, 1), ValueError, "constant: must have one dimension, has 2"),
            ((ones, ones, ones, "thick"), TypeError, "density: must be real numbers, is an array of <U5"),
            ((ones, ones, ones, 1, np.ones(3)), ValueError, "threshold: must have 4 values, has 3"),
        ):
            with self.assertRaises(error) as raised:
                litfog.solve_fog_intensities(*columns)
            self.assertTrue(str(raised.exception).startswith(sentence), raised.exception)
        for out, error, sentence in (
            (np.zeros(3), ValueError, "out.intensity: must have 4 values, has 3"),
            (np.zeros(4, np.float32), TypeError, "out.intensity: must be a NumPy array of float64, is one of float32"),
            (read_only, ValueError, "out.intensity: must be writeable"),
            (ones, ValueError, "out.intensity: must not overlap constant"),
            (np.zeros(8)[::2], ValueError, "out.intensity: must be contiguous and aligned"),
            (unaligned, ValueError, "out.intensity: must be contiguous and aligned"),
        ):
            with self.assertRaises(error) as raised:
                litfog.solve_fog_intensities(ones, ones, ones, 1, out=litfog.BatchSolutions(intensity=out))
            self.assertEqual(str(raised.exception), sentence)
        with self.assertRaisesRegex(TypeError, "^out: must be a BatchSolutions, is of type ndarray$"):
            litfog.solve_fog_intensities(ones, ones, ones, 1, out=np.zeros(4))
        with self.assertRaisesRegex(TypeError, "^out.intensity: must be a NumPy array of float64, is of type NoneType$"):
            litfog.solve_fog_intensities(ones, ones, ones, 1, out=litfog.BatchSolutions(None, peak_range=np.zeros(4)))

    def test_columns_of_any_type_and_layout_are_solved_as_floats_where_all_arrays_are(self):
        ones = np.ones(4)
        whole = litfog.solve_fog_intensities(ones, ones, ones, 0.1).intensity
        for given in (ones.astype(">f8"), np.ones(8)[::2], np.ones(33, np.uint8)[1:].view("u1")[:4], [1] * 4, 1):
            solved = litfog.solve_fog_intensities(ones, given, ones, 0.1).intensity
            np.testing.assert_array_equal(solved, whole)
        floats = ones.astype("f4")
        self.assertEqual(litfog.solve_fog_intensities(floats, 1, [1] * 4, 0.1).intensity.dtype, np.float32)
        self.assertEqual(litfog.solve_fog_intensities(floats, ones, 1, 0.1).intensity.dtype, np.float64)

    def test_another_thread_runs_while_a_batch_is_solved(self):
        count = 1_500_000
        constant, linear, quadratic = np.ones(count), np.full(count, 1e-3), np.full(count, 1e-4)
        out = litfog.BatchSolutions(intensity=np.zeros(count))
        # With the GIL held this thread could not run within the call at all.
        times = []
        done = threading.Event()

        def watch():
            while not done.is_set():
                times.append(time.perf_counter())
                time.sleep(0.0005)

        watcher = threading.Thread(target=watch)
        watcher.start()
        try:
            begin = time.perf_counter()
            for _ in range(20):
                litfog.solve_fog_intensities(constant, linear, quadratic, 0.01, out=out)
                end = time.perf_counter()
                inner = [t for t in times if begin + 0.2 * (end - begin) < t < begin + 0.8 * (end - begin)]
                if len(inner) >= 3:
                    break
                begin = time.perf_counter()
        finally:
            done.set()
            watcher.join()
        self.assertGreaterEqual(len(inner), 3)


class RuleTest(unittest.TestCase):
    def test_records_are_not_made_of_values_that_break_their_rule(self):
        for record, members, sentence in (
            (litfog.Attenuation, {"constant": -1}, "attenuation.constant = -1: must be finite and >= 0"),
            (litfog.Fog, {"density": -1}, "fog.density = -1: must be >= 0"),
            (litfog.FogLayer, {"base": 4, "top": 3}, "top = 3: must be above the base"),
            (litfog.PhaseLobe, {"asymmetry": 2}, "asymmetry = 2: must be in (-1, 1)"),
            (litfog.Phase.henyey_greenstein, {"asymmetry": 2}, "asymmetry = 2: must be in (-1, 1)"),
            (litfog.Phase, {"weight": 2}, "weight = 2: must be in [0, 1]"),
            (litfog.Atmosphere, {"albedo": 2}, "albedo = 2: must be in [0, 1]"),
            (litfog.Cone.cosine, {"half_angle": 0, "exponent": 2}, "cone.half_angle = 0: must be in (0, pi/2]"),
            (litfog.Cone.smoothstep, {"inner": 1, "outer": 1}, "cone.inner = 1: must be in [0, outer)"),
            (litfog.Cone, {"profile": "cosine"}, "cone.half_angle = 0: must be in (0, pi/2]"),
            (litfog.Flash, {"period": 1, "flashes": [(0, 2, 1)]}, "flash.flashes[0].duration = 2: must end within the period"),
            (litfog.Light, {"threshold": 1}, "threshold = 1: must be in (0, 1)"),
            (litfog.PlacedLight, {"light": litfog.Light(), "direction": (0, 2, 0)}, "direction = 2: length must be 1 within 1e-6"),
        ):  # fmt: skip
            with self.assertRaises(ValueError) as raised:
                record(**members)
            self.assertEqual(str(raised.exception), sentence)

    def test_values_that_break_their_rule_are_refused_where_cpp_leaves_them_to_the_caller(self):
        fog, attenuation, cone = litfog.Fog(density=0.01), litfog.Attenuation(1, 0, 0.01), litfog.Cone.cosine(0.5, 2)
        for call, arguments, sentence in (
            (litfog.attenuation_at, (attenuation, [1, -5]), "range = -5: must be >= 0"),
            (litfog.fog_factor_at, (fog, math.nan), "range = nan: must be >= 0"),
            (litfog.opacity_at, (fog, -1), "range = -1: must be >= 0"),
            (litfog.cone_at, (cone, [1, 2]), "cos_angle = 2: must be in [-1, 1]"),
            (litfog.flux_within, (cone, 4), "angle = 4: must be in [0, pi]"),
            (litfog.angle_at_level, (cone, 1), "level = 1: must be in (0, 1)"),
        ):
            with self.subTest(call=call.__name__, sentence=sentence), self.assertRaises(ValueError) as raised:
                call(*arguments)
            self.assertEqual(str(raised.exception), sentence)


    def test_numbers_that_floats_round_beyond_a_limit_are_the_limit(self):
        half, whole = float(np.float32(math.pi / 2)), float(np.float32(math.pi))
        given, meant = litfog.Cone.cosine(half, 4), litfog.Cone.cosine(math.pi / 2, 4)
        self.assertGreater(half, math.pi / 2)
        self.assertEqual(litfog.flux_within(given, whole), litfog.flux_within(meant, math.pi))
        self.assertEqual(litfog.cone_at(given, 1 + 2**-23), 1)
        litfog.FogUpdater().add(litfog.PlacedLight(litfog.Light(cone=litfog.Cone.smoothstep(0.5, whole))))
        fitted = litfog.fit_cone(profile=litfog.ConeProfile.cosine, half_angle=half, beam_angle=1).best.cone
        self.assertEqual(fitted.half_angle, math.pi / 2)


class LayersTest(unittest.TestCase):
    def test_layers_make_a_profile_that_the_air_adds_to_its_fog(self):
        ground = litfog.FogLayer(top=100, transition=20, visibility=300)
        profile = litfog.DensityProfile.from_layers([ground])
        dense = litfog.Fog.from_visibility(litfog.FogMode.exp, 300).density
        self.assertEqual(list(profile.knots), [(100, dense), (120, 0)])
        air = litfog.Atmosphere(litfog.Fog(density=0.001), profile=profile)
        self.assertAlmostEqual(air.fog_between(100, 120).density, 0.001 + dense / 2, 15)
        self.assertEqual(air.fog_between(500, 500), air.fog)
        self.assertEqual(profile.replace(knots=[(0, 1), (1, 0)]), litfog.DensityProfile([(0, 1), (1, 0)]))

    def test_wrong_layers_raise_field_value_and_rule(self):
        with self.assertRaisesRegex(ValueError, "^top = 3: must be above the base$"):
            litfog.DensityProfile.from_layers([litfog.FogLayer(base=4, top=3, visibility=10)])
        with self.assertRaisesRegex(ValueError, r"^profile\.knots\[1\]\.height = 1: must be above the knot before$"):
            litfog.DensityProfile([(1, 0), (1, 1)])
        with self.assertRaisesRegex(ValueError, "^profile.count = 1: must be 0 in exp2 fog$"):
            litfog.Atmosphere(litfog.Fog("exp2"), profile=litfog.DensityProfile([(1, 0)]))


class AirlightTest(unittest.TestCase):
    def setUp(self):
        self.fog = litfog.Fog.from_visibility(litfog.FogMode.exp, 1500)
        self.air = litfog.Atmosphere(self.fog)
        self.light = litfog.PlacedLight(litfog.Light(attenuation=litfog.Attenuation(1, 0, 9.5e-5)), (0, 30, -200))

    def test_rays_of_any_shape_are_read_and_written_where_they_lie(self):
        rays = np.zeros((3, 5), litfog.EYE_RAY)
        rays["direction"] = (0, 0, -1)
        rays["length"] = np.linspace(10, 1000, 15).reshape(3, 5)
        rays[0, 0]["length"] = math.inf
        airlights = litfog.airlight(self.light, self.air, rays)
        self.assertEqual(airlights.shape, (3, 5))
        self.assertAlmostEqual(airlights[0, 0], 0.256, 3)  # as the README's program prints it
        self.assertTrue(np.all(np.diff(airlights.ravel()[1:]) >= 0))
        out = np.zeros((3, 5))
        self.assertIs(litfog.airlight(self.light, self.air, rays, out=out), out)
        many, written = np.zeros(2000, litfog.EYE_RAY), np.zeros(2000)
        many["direction"] = (1, 0, 0)
        self.assertLess(allocated_by(lambda: litfog.airlight(self.light, self.air, many, out=written)), 10_000)
        np.testing.assert_array_equal(out, airlights)
        single = litfog.airlight(self.light, self.air, rays[0, :1])
        self.assertEqual(single[0], airlights[0, 0])
        forward = litfog.airlight(self.light, litfog.Atmosphere(self.air.fog, litfog.Phase.henyey_greenstein(0.8)), rays)
        self.assertTrue(np.all(forward != airlights))

    def test_rays_that_do_not_fit_are_refused_before_results_are_written(self):
        rays = np.zeros(2, litfog.EYE_RAY)
        rays["direction"] = [(0, 0, -1), (0, 0, -2)]
        out = np.full(2, 7.0)
        with self.assertRaisesRegex(ValueError, "length must be 1 within 1e-6"):
            litfog.airlight(self.light, self.air, rays, out=out)
        np.testing.assert_array_equal(out, [7, 7])
        with self.assertRaisesRegex(TypeError, "^rays: must be a NumPy array of .*origin.*, is one of float64$"):
            litfog.airlight(self.light, self.air, np.zeros((2, 7)))
        with self.assertRaisesRegex(ValueError, r"^out: must have the shape \(2,\), has \(3,\)$"):
            litfog.airlight(self.light, self.air, rays, out=np.zeros(3))
        with self.assertRaisesRegex(ValueError, "^out: must not overlap rays$"):
            litfog.airlight(self.light, self.air, rays, out=rays.view(np.float64)[:2])

    def test_all_orders_of_scattering_add_to_airlight(self):
        table = litfog.make_scattering_table(self.air)
        self.assertEqual((table.dtype, table.ndim), (np.float32, 2))
        rays = np.zeros((2, 3), litfog.EYE_RAY)
        rays["direction"] = (0, 0, -1)
        rays["length"] = np.linspace(10, 1000, 6).reshape(2, 3)
        scattered = litfog.multiple_scattering(self.light, self.air, table, rays)
        self.assertEqual(scattered.shape, (2, 3))
        self.assertTrue(np.all(np.diff(scattered.ravel()) > 0))
        out = np.zeros((2, 3))
        self.assertIs(litfog.multiple_scattering(self.light, self.air, table, rays, out=out), out)
        np.testing.assert_array_equal(out, scattered)
        thin = litfog.effective_intensity(litfog.Attenuation(0, 0, 4), 1e-6)
        self.assertAlmostEqual(thin, 0.25, 6)
        with self.assertRaisesRegex(ValueError, "^albedo = 0.5: must be 1 for all orders of scattering$"):
            litfog.make_scattering_table(litfog.Atmosphere(self.fog, albedo=0.5))
        with self.assertRaisesRegex(ValueError, r"^table: must be one of make_scattering_table, has the shape \(3,\)$"):
            litfog.multiple_scattering(self.light, self.air, np.zeros(3, np.float32), rays)
        with self.assertRaisesRegex(TypeError, "^table: must be a NumPy array of float32, is one of float64$"):
            litfog.multiple_scattering(self.light, self.air, np.zeros((12, 18)), rays)
        with self.assertRaisesRegex(ValueError, "^table = nan: must be at most 100 in magnitude$"):
            litfog.multiple_scattering(self.light, self.air, table * np.float32(np.nan), rays)

    def test_fog_lights_surfaces(self):
        table = litfog.make_scattering_table(self.air)
        beams = litfog.make_thin_beams(self.air, table)
        self.assertEqual((beams.dtype, beams.shape), (litfog.THIN_BEAM, (16,)))
        lamp = litfog.Light(attenuation=litfog.Attenuation(1, 0, 9.5e-5), cone=litfog.Cone.cosine(0.5, 2))
        source = litfog.scattering_source(lamp, self.air, beams)
        self.assertEqual(source.intensity, litfog.effective_intensity(lamp.attenuation, self.fog.density))
        self.assertEqual((source.is_cone, source.phase_cosine), (True, 0))
        self.assertTrue(0 < source.soft_range < 3 / self.fog.density)
        self.assertEqual((source.beam.shape, source.beam.dtype), ((16, 24, 4), np.float32))
        self.assertFalse(source.beam.flags.writeable)
        placed = litfog.PlacedLight(lamp)  # it shines along -z
        places = np.array([[[0, 0, -50], [0, 0, 50]], [[50, 0, 0], [0, 50, 0]]], float)
        scattered = litfog.scattered_light(placed, source, self.air, places)
        self.assertEqual(scattered.shape, (2, 2, 4))
        self.assertGreater(scattered[0, 0, 0], scattered[0, 1, 0])
        self.assertLess(scattered[0, 0, 3], 0)
        np.testing.assert_array_equal(litfog.scattered_light(placed, source, self.air, [0, 0, -50]), scattered[0, 0])
        facing = litfog.irradiance(scattered, [0, 0, 1])
        self.assertEqual(facing.shape, (2, 2))
        self.assertEqual(litfog.irradiance(scattered[0, 0], (0, 0, 1)), facing[0, 0])
        self.assertGreater(facing[0, 0], litfog.irradiance(scattered[0, 0], (0, 0, -1)))
        np.testing.assert_allclose(litfog.irradiance(2 * scattered[:, 0], np.eye(3)[1:]),
                                   [2 * litfog.irradiance(scattered[0, 0], (0, 1, 0)), 2 * facing[1, 0]])  # fmt: skip
        unknown = beams.copy()
        unknown["share"][3, 5] = math.nan
        for error, call in (
            (r"^positions: must have a last axis of 3, has the shape \(2,\)$",
             lambda: litfog.scattered_light(placed, source, self.air, [1, 2])),
            ("^position.x = inf: must be at most 16777216 in magnitude$",
             lambda: litfog.scattered_light(placed, source, self.air, [math.inf, 0, 0])),
            ("^normal = 2: length must be 1 within 1e-6$", lambda: litfog.irradiance(scattered, [0, 2, 0])),
            (r"^all = -1: must be in \[0, 1e100\]$", lambda: litfog.irradiance([-1, 0, 0, 0], [0, 1, 0])),
            (r"^light: must have a last axis of 4, has the shape \(\)$", lambda: litfog.irradiance(1, [0, 1, 0])),
            (r"^beams: must be those of make_thin_beams, has the shape \(15,\)$",
             lambda: litfog.scattering_source(lamp, self.air, beams[:15])),
            ("^beams.share = nan: must be at most 1000 in magnitude$",
             lambda: litfog.scattering_source(lamp, self.air, unknown)),
        ):  # fmt: skip
            self.assertRaisesRegex(ValueError, error, call)

    def test_sun_lights_fog_from_its_top_down(self):
        rays = np.zeros((2, 3), litfog.EYE_RAY)
        rays["direction"], rays["length"] = (0, 0, -1), np.linspace(10, 1000, 6).reshape(2, 3)
        hazy = litfog.Atmosphere(litfog.Fog("exp", 1e-4))  # up to 1200 m
        lit = litfog.directional_airlight(hazy, (0, 1, 0), rays)
        np.testing.assert_allclose(lit, math.exp(-0.12) * -np.expm1(-rays["length"] * 1e-4), rtol=1e-12)
        ground = litfog.Atmosphere(self.fog, top=40)
        lit, out = litfog.directional_airlight(ground, (0, 1, 0), rays), np.zeros((2, 3))
        self.assertIs(litfog.directional_airlight(ground, (0, 1, 0), rays, out=out), out)
        np.testing.assert_array_equal(out, lit)
        left = litfog.directional_fog_factor(ground, (0, 1, 0), [0, 40])
        np.testing.assert_allclose(left, [math.exp(-40 * self.fog.density), 1], rtol=1e-14)
        np.testing.assert_allclose(lit, left[0] * -np.expm1(-rays["length"] * self.fog.density), rtol=1e-12)
        with self.assertRaisesRegex(ValueError, "^to_light = 2: length must be 1 within 1e-6$"):
            litfog.directional_airlight(ground, (0, 2, 0), rays)
        with self.assertRaisesRegex(ValueError, "^fog.mode = 1: must be exp$"):
            litfog.directional_fog_factor(litfog.Atmosphere(litfog.Fog("exp2", 0.1)), (0, 1, 0), 0)

    def test_reach_holds_what_shows(self):
        budgets = litfog.reach_budget(0.5 / 255, 1000, np.array([1, 1e4]), self.air)
        np.testing.assert_allclose(budgets, [0.8 * 0.5 / 255 / 1000, 0.8 * 0.5 / 255 / 1e7])
        self.assertRaisesRegex(ValueError, "^step = 0: must be finite and > 0$", litfog.reach_budget, 0, 1, 1, self.air)
        reach = litfog.light_reach(self.light.light, self.fog, 1 / 255)
        shown = litfog.attenuation_at(self.light.light.attenuation, reach) * litfog.fog_factor_at(self.fog, reach)
        self.assertTrue(0 < reach <= litfog.compute_extent(self.light.light.attenuation))
        self.assertTrue(shown <= 1 / 255 or reach == litfog.compute_extent(self.light.light.attenuation))


class UpdaterTest(unittest.TestCase):
    lamp = litfog.Light(attenuation=litfog.Attenuation(1, 0, 9.5e-5))

    def test_tables_are_views_that_follow_the_fog(self):
        updater = litfog.FogUpdater()
        handle = updater.add(litfog.PlacedLight(self.lamp, (1, 2, 3), carried=True))
        other = updater.add(litfog.PlacedLight(self.lamp, (4, 5, 6)))
        self.assertEqual(len({handle, other, handle}), 2)
        fog = litfog.Fog(density=0.003)
        changes = updater.set_fog(fog)
        self.assertEqual((changes.kinds, changes.instances), ([slice(0, 2, 1)], [slice(0, 2, 1)]))
        kinds, instances = updater.kinds, updater.instances
        self.assertEqual((kinds.dtype, instances.dtype), (litfog.FOG_LIGHT_KIND, litfog.FOG_LIGHT_INSTANCE))
        self.assertEqual((address(kinds), kinds.flags.writeable), (address(updater.kinds), False))
        kind = updater.kind_of(handle)
        solved = litfog.solve_fog_intensity(self.lamp.attenuation, fog)
        self.assertEqual(kinds[kind]["cone_scale_intensity"][3], np.float32(solved.intensity))
        self.assertEqual(list(instances[updater.instance_of(other)]["position_kind"][:3]), [4, 5, 6])

        thicker = litfog.Fog(density=0.03)
        changes = updater.set_fog(thicker)
        self.assertEqual((changes.kinds, changes.instances), ([slice(kind, kind + 1, 1)], []))
        solved = litfog.solve_fog_intensity(self.lamp.attenuation, thicker)
        self.assertEqual(kinds[kind]["cone_scale_intensity"][3], np.float32(solved.intensity))  # the same view
        self.assertEqual((updater.statistics.kinds_solved, updater.statistics.bytes_dirty), (1, 32))

        updater.switch_light(other, False)
        changes = updater.set_fog(thicker)
        self.assertEqual(list(instances[changes.instances[0]][0]["color"][:3]), [0, 0, 0])

    def test_sources_are_solved_where_asked_for(self):
        updater = litfog.FogUpdater()
        handle = updater.add(litfog.PlacedLight(self.lamp))
        fog = litfog.Fog(density=0.003)
        self.assertEqual(updater.set_fog(fog).sources, [])
        self.assertEqual(updater.sources.shape, (0,))
        updater.solve_sources()
        changes = updater.set_fog(fog)
        self.assertEqual((changes.kinds, changes.sources), ([], [slice(0, 1, 1)]))
        self.assertEqual((updater.statistics.sources_solved, updater.statistics.bytes_dirty), (1, 8))
        layer = litfog.FogLayer(base=0, top=10, transition=5, visibility=150)
        profile = litfog.DensityProfile.from_layers([layer])
        air = litfog.Atmosphere(fog, litfog.Phase.droplets(10), profile=profile)
        self.assertEqual(updater.set_atmosphere(air, eye_height=100).sources, [slice(0, 1, 1)])
        solved = updater.sources
        self.assertEqual((solved.dtype, solved.flags.writeable), (litfog.FOG_LIGHT_SOURCE, False))
        beams = litfog.make_thin_beams(air, litfog.make_scattering_table(air))
        found, expected = solved[updater.kind_of(handle)], litfog.scattering_source(self.lamp, air, beams)
        self.assertEqual(tuple(found), (np.float32(expected.intensity), np.float32(expected.soft_range)))
        with self.assertRaisesRegex(ValueError, "^eye_height = nan: must be a number$"):
            updater.set_atmosphere(air, math.nan)

    def test_lights_flash_by_the_time(self):
        flash = litfog.Flash(2, [(0.5, 0.25, 5)])
        self.assertEqual(list(litfog.flash_at(flash, np.array([0, 0.5, 0.75, 2.5]))), [0, 5, 0, 5])
        updater = litfog.FogUpdater()
        updater.add(litfog.PlacedLight(litfog.Light(flash=flash)))
        for seconds, red in ((0, 0), (0.5, 5), (1, 0)):
            updater.set_time(seconds)
            updater.set_fog(litfog.Fog(density=0.003))
            self.assertEqual(updater.instances[0]["color"][0], red)

    def test_tables_do_not_move_while_views_exist_and_live_as_long_as_these(self):
        updater = litfog.FogUpdater()
        handle = updater.add(litfog.PlacedLight(self.lamp))
        updater.set_fog(litfog.Fog(density=0.003))
        row = updater.instances[:1]
        for change in (lambda: updater.add(litfog.PlacedLight(self.lamp)),
                       lambda: updater.change(handle, litfog.PlacedLight(self.lamp))):
            self.assertRaisesRegex(BufferError, "^views of the updater's tables exist", change)
        del row
        updater.change(handle, litfog.PlacedLight(self.lamp, (7, 8, 9)))
        updater.set_fog(litfog.Fog(density=0.003))
        row = updater.instances
        del updater
        self.assertEqual(list(row[0]["position_kind"][:3]), [7, 8, 9])

    def test_handles_of_no_light_are_refused(self):
        updater = litfog.FogUpdater()
        handle = updater.add(litfog.PlacedLight(self.lamp))
        updater.remove(handle)
        self.assertRaises(ValueError, updater.switch_light, handle, True)


class FileTest(unittest.TestCase):
    def test_lights_are_written_and_read_back(self):
        light = litfog.Light("lamp", (1, 0.9, 0.8), litfog.Attenuation(1, 0.1, 0.01), 0.1, litfog.Cone(), 0.4)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lamp.json")
            litfog.write_light(path, light, ["a test"])
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), litfog.format_light(light, ["a test"]))
            self.assertEqual(repr(litfog.read_light(path)), repr(light))
            with self.assertRaisesRegex(litfog.OutputError, "missing/lamp.json: cannot be written"):
                litfog.write_light(os.path.join(folder, "missing", "lamp.json"), light)

    def test_errors_of_files_have_file_line_and_column(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lamp.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write('{"litfog": "light", "version": 1,\n "attenuation": {"constant": 1},\n "threshold": -7}')
            with self.assertRaises(litfog.InputError) as raised:
                litfog.read_light(path)
            error = raised.exception
            self.assertEqual((error.file, error.line, error.column), (path, 3, 15))
            self.assertEqual(str(error), path + ":3:15: threshold = -7: must be in (0, 1)")
            self.assertIsInstance(error, ValueError)
            sent = pickle.loads(pickle.dumps(error))  # as from another process
            self.assertEqual((str(sent), sent.file, sent.line, sent.column), (str(error), path, 3, 15))
            with self.assertRaises(litfog.InputError) as raised:  # a name that is no UTF-8
                litfog.read_light(os.fsencode(folder) + b"/\xff.json")
            self.assertEqual(os.fsencode(raised.exception.file), os.fsencode(folder) + b"/\xff.json")


class PhotometryTest(unittest.TestCase):
    def test_files_are_read_as_tables_with_flux_and_profile(self):
        luminaire = litfog.read_luminaire(os.path.join(test_data, "photometry", "runway_edge_light.ldt"))
        distribution = luminaire.distribution
        table = distribution.intensity
        self.assertEqual(table.shape, (distribution.horizontal.size, distribution.vertical.size))
        self.assertEqual((address(table), table.flags.writeable), (address(distribution.intensity), False))
        self.assertEqual(table.max(), litfog.find_peak(distribution).intensity)
        flux, stated = litfog.luminous_flux(distribution), litfog.stated_flux(luminaire)
        self.assertLess(abs(flux / stated - 1), 0.1)
        profile = litfog.axial_profile(distribution)
        self.assertEqual((profile.dtype, profile["angle"][0], profile["angle"][-1]), (litfog.AXIAL_SAMPLE, 0, math.pi))
        self.assertTrue(0 <= litfog.asymmetry(distribution) <= 1)
        del luminaire, distribution
        self.assertGreater(table.max(), 0)  # it lives as long as its view
        self.assertRaises(litfog.InputError, litfog.read_luminaire, stub_file)

    def test_container_reads_each_of_its_files(self):
        lamp = os.path.join(test_data, "photometry", "runway_edge_light.ldt")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "set.gldf")
            with zipfile.ZipFile(path, "w") as archive:
                files = "".join(f'<File contentType="ldc/eulumdat">{name}.ldt</File>' for name in "ab")
                root = f"<Root><GeneralDefinitions><Files>{files}</Files></GeneralDefinitions></Root>"
                archive.writestr("product.xml", root)
                for name in "ab":
                    archive.write(lamp, f"ldc/{name}.ldt")
            container = litfog.GldfContainer(path)
            self.assertEqual(container.files, [os.path.join(path, "ldc", f"{name}.ldt") for name in "ab"])
            self.assertEqual(container.files, litfog.list_gldf(path))
            for file in container.files:
                self.assertEqual(container.read(file).lamp_flux, litfog.read_luminaire(lamp).lamp_flux)


class FitTest(unittest.TestCase):
    def test_attenuations_are_found_again(self):
        wanted = litfog.Attenuation(0.8, 0.02, 0.003)
        ranges = np.linspace(10, 90, 9)
        fit = litfog.fit_attenuation(ranges=ranges, attenuations=litfog.attenuation_at(wanted, ranges))
        self.assertEqual(fit.status, litfog.AttenuationFitStatus.optimal)
        for name in ("constant", "linear", "quadratic"):
            self.assertAlmostEqual(getattr(fit.attenuation, name), getattr(wanted, name), 8)
        self.assertEqual((fit.residuals.size, fit.covariance.shape), (9, (3, 3)))
        met = litfog.fit_attenuation(extent=100)
        self.assertAlmostEqual(litfog.compute_extent(met.attenuation), 100, 9)
        with self.assertRaisesRegex(ValueError, r"^samples\[1\]\.attenuation = 0: must be in \[1e-100, 1\]$"):
            litfog.fit_attenuation(ranges=[1, 2], attenuations=[1, 0])
        with self.assertRaisesRegex(ValueError, "^ranges, attenuations and weights: must be one-dimensional and of one"):
            litfog.fit_attenuation(ranges=[1, 2], attenuations=[1])

    def test_every_profile_has_a_constructor_and_a_fit(self):
        for name, profile in litfog.ConeProfile.__members__.items():
            with self.subTest(profile=name):
                if profile == litfog.Cone().profile:
                    continue
                cone = getattr(litfog.Cone, name)(0.2, 0.5)
                self.assertEqual(cone.profile, profile)
                self.assertEqual(litfog.fit_cone(profile=profile, beam_angle=0.5).best.cone.profile, profile)

    def test_cones_are_found_again(self):
        wanted = litfog.Cone.smoothstep(0.1, 0.4)
        angles = np.linspace(0, 0.6, 40)
        fit = litfog.fit_cone(angles=angles, intensities=500 * litfog.cone_at(wanted, np.cos(angles)))
        self.assertEqual(fit.best.cone.profile, litfog.ConeProfile.smoothstep)
        self.assertAlmostEqual(fit.best.cone.inner, 0.1, 4)
        self.assertAlmostEqual(fit.best.cone.outer, 0.4, 4)
        beam = litfog.fit_cone(profile=litfog.ConeProfile.cosine, beam_angle=0.5).best.cone
        self.assertAlmostEqual(litfog.angle_at_level(beam, 0.5), 0.25, 4)
        self.assertTrue(0 < litfog.flux_within(beam, math.pi) < 4 * math.pi)

    def test_fits_come_back_from_other_processes_with_all_that_they_show(self):
        ranges, angles = np.array([10, 20, 40, 80, 160]), np.linspace(0, 0.6, 40)
        fits = [
            litfog.fit_attenuation(extent=100),
            litfog.fit_attenuation(ranges=ranges, attenuations=[0.9, 0.66, 0.31, 0.102, 0.03], threshold=0.04),
            litfog.fit_cone(angles=angles, intensities=1 - angles),
            litfog.fit_cone(profile=litfog.ConeProfile.cosine, beam_angle=0.5),
        ]
        self.assertIsNone(fits[0].covariance)
        self.assertIsNotNone(fits[1].covariance)
        self.assertIsNotNone(fits[2].best.covariance)

        def expect_same(fit, sent):
            members = [name for name in dir(fit) if not name.startswith("_")]
            self.assertGreaterEqual(len(members), 3)
            for name in members:
                value, other = getattr(fit, name), getattr(sent, name)
                if name == "best":
                    expect_same(value, other)
                elif name == "profiles":
                    for pair in zip(value, other, strict=True):
                        expect_same(*pair)
                else:
                    np.testing.assert_equal(other, value, name)

        for fit in fits:
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                expect_same(fit, pickle.loads(pickle.dumps(fit, protocol)))
        with self.assertRaisesRegex(ValueError, "^best_index: must be that of a profile$"):
            litfog.ConeFit(fits[2].profiles, 2)  # which would have no best


class FaceTest(unittest.TestCase):
    def test_every_public_name_has_a_text_and_stands_in_the_stub(self):
        with open(stub_file, encoding="utf-8") as file:
            stub = ast.parse(file.read())

        def names_of(nodes):
            names = {}
            for node in nodes:
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    names[node.name] = node
                elif isinstance(node, ast.AnnAssign):
                    names[node.target.id] = node
                elif isinstance(node, ast.Assign):
                    names[node.targets[0].id] = node
            return {name: node for name, node in names.items() if not name.startswith("_")}

        def public(owner):
            return {name for name in vars(owner) if not name.startswith("_")}

        stubs = names_of(stub.body)
        self.assertEqual(public(litfog), set(stubs))
        for name in public(litfog):
            value = getattr(litfog, name)
            if isinstance(value, (float, tuple, np.dtype)):
                continue
            self.assertTrue(value.__doc__, name)
            if not isinstance(value, type) or issubclass(value, Exception):
                continue
            members = public(value) - ({"name", "value"} if hasattr(value, "__members__") else set())
            self.assertEqual(members, set(names_of(stubs[name].body)), name)
            for member in members:
                if not hasattr(value, "__members__"):
                    self.assertTrue(getattr(value, member).__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes photometric files of real lamps beside itself, and prints what ies_test.cpp and eulumdat_test.cpp expect of them.

The figures and their sources stand with each lamp; what no source gives is called assumed. The expected fluxes come from
Simpson's rule over each cell of the measured grid, the library's from a closed form.
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).parent


def write(name, text, encoding="utf-8"):
    (FOLDER / name).write_bytes(text.encode(encoding))


def numbers(values, separator=" "):
    return separator.join(f"{value:.10g}" for value in values)


def lines_of(values, count, separator=" ", end="\n"):
    return "".join(numbers(values[i:i + count], separator) + end for i in range(0, len(values), count))


def simpson(function, low, high, steps=64):
    h = (high - low) / steps
    inner = sum((4 if i % 2 else 2) * function(low + i * h) for i in range(1, steps))
    return h / 3 * (function(low) + inner + function(high))


def cell_flux(h, v, corners, sine):
    """Flux of a cell, bilinear between its corners [h][v]; `sine` weighs one angle of the two, all in degrees."""
    def at(x, y):
        s, t = (x - h[0]) / (h[1] - h[0]), (y - v[0]) / (v[1] - v[0])
        return ((1 - s) * ((1 - t) * corners[0][0] + t * corners[0][1]) +
                s * ((1 - t) * corners[1][0] + t * corners[1][1]))
    return simpson(lambda x: simpson(lambda y: at(x, y) * sine(x, y), *v, 16), *h, 16) * math.radians(1) ** 2


def flux(horizontal, vertical, planes, sine):
    return sum(cell_flux(horizontal[i:i + 2], vertical[j:j + 2],
                         [planes[i][j:j + 2], planes[i + 1][j:j + 2]], sine)
               for i in range(len(horizontal) - 1) for j in range(len(vertical) - 1))


def sin_of_gamma(_, gamma):
    return math.sin(math.radians(gamma))


def cos_of_h(h, _):
    return math.cos(math.radians(h))


def landing_lamp():
    """GE 4509, 100 W, 4 1/2 in: about 100,000 cd (General Electric, 1945). Assumed: 10^-(angle / 6 degrees)^2 of it off
    the axis, and 1,900 lm of the lamp. A Latin-1 byte, feet, and a multiplier of 1.498."""
    gamma = [0, 1, 2, 3, 3.5, 4, 5, 6, 7, 8, 10, 12, 15]
    candela = [100_000 * 10 ** -(g / 6) ** 2 for g in gamma]
    multiplier = 1.498
    stored = [round(c / multiplier, 1) for c in candela]
    text = ("IESNA:LM-63-1991\r\n[LUMINAIRE] GE 4509, 100 W, 4\xBD in\r\n[MANUFAC] General Electric\r\n"
            "[OTHER] 100,000 cd: General Electric, 1945; the beam's shape is assumed\r\nTILT=NONE\r\n"
            f"1 1900 {multiplier} {len(gamma)} 1 1 1 -0.375 -0.375 0.25\r\n1.0 1.0 100\r\n")
    text += lines_of(gamma, 10, end="\r\n") + "0\r\n" + lines_of(stored, 8, end="\r\n")
    write("landing_lamp.ies", text, "latin-1")
    planes = [[s * multiplier for s in stored]] * 2
    return flux([0, 360], gamma, planes, sin_of_gamma), planes[0], gamma


def approach_light():
    """Approach centre line light, EASA CS ADR-DSN.U.940: isocandela ellipses with half axes of 10 x 5.5 degrees (main
    beam), 14 x 6.5 (10 %) and 15 x 8.5 (5 %). Assumed: 30,000 cd all over the main beam, a logarithmic fall between the
    ellipses, 0 at 1.2 times the last one. Type B, a quadrant, tabs."""
    ellipses = [(10, 5.5, 30_000), (14, 6.5, 3_000), (15, 8.5, 1_500)]

    def candela(h, v):
        radius = [math.hypot(h / a, v / b) for a, b, _ in ellipses]
        if radius[0] <= 1:
            return ellipses[0][2]
        for i in (0, 1):
            if radius[i + 1] <= 1:
                t = (radius[i] - 1) / (radius[i] - radius[i + 1])
                return round(ellipses[i][2] * (ellipses[i + 1][2] / ellipses[i][2]) ** t, 1)
        return 0 if radius[2] >= 1.2 else round(ellipses[2][2] * (1.2 - radius[2]) / 0.2, 1)

    horizontal = [0, 2, 4, 6, 8, 10, 11, 12, 13, 14, 15, 18]
    vertical = [0, 1, 2, 3, 4, 5, 5.5, 6, 6.5, 7.5, 8.5, 10.2]
    planes = [[candela(h, v) for v in vertical] for h in horizontal]
    text = ("IESNA:LM-63-2002\n[LUMINAIRE] approach centre line\n[TEST] EASA CS ADR-DSN.U.940\nTILT=NONE\n"
            f"1\t-1\t1\t{len(vertical)}\t{len(horizontal)}\t2\t2\t0.2\t0.2\t0\n1\t1\t200\n")
    text += numbers(vertical, "\t") + "\n" + numbers(horizontal, "\t") + "\n"
    text += "".join(numbers(plane, "\t") + "\n" for plane in planes)
    write("approach_light.ies", text)
    return 4 * flux(horizontal, vertical, planes, cos_of_h), [plane[0] for plane in planes], horizontal


def position_light():
    """Left position light, 14 CFR 23.1391 and 25.1393: 40 cd from 0 to 10 degrees off the nose, 30 to 20, 5 to 110;
    times 1.00 on the horizon, .90 to 5 degrees off it, .80 to 10, .70 to 15, .50 to 20, .30 to 30, .10 to 40, .05 to 90.
    Nine planes of type C about the vertical, of which the last closes the turn; the light goes up and down alike."""
    azimuth = [0, 10, 20, 110, 120, 180, 270, 350, 360]
    ahead = [40, 40, 30, 5, 0, 0, 0, 0, 40]
    below = [(90, 0.05), (40, 0.05), (30, 0.1), (20, 0.3), (15, 0.5), (10, 0.7), (5, 0.8), (0, 1)]
    gamma = [90 - e for e, _ in below] + [90 + e for e, _ in below[-2::-1]]
    factor = [f for _, f in below] + [f for _, f in below[-2::-1]]
    planes = [[round(candela * f, 2) for f in factor] for candela in ahead]
    text = ("IESNA91\n[LUMINAIRE] left position light\n[TEST] 14 CFR 23.1391, 25.1393\nTILT=NONE\n"
            f"1,-1,1,{len(gamma)},{len(azimuth)},1,2,0.05,0.1,0.05\n1,1,26\n")
    text += lines_of(gamma, 6) + lines_of(azimuth, 6) + "".join(lines_of(plane, 7) for plane in planes)
    write("position_light.ies", text)
    return flux(azimuth, gamma, planes, sin_of_gamma), planes[0][7:], [g - 90 for g in gamma[7:]]


def runway_edge_light():
    """Bidirectional runway edge light, EASA CS ADR-DSN.U.940: yellow is 0.40 of white, toe-in 3.5 degrees. Assumed:
    10,000 cd white, beams that fall linearly to 0 within 12 degrees, 3,000 lm of lamps. EULUMDAT with decimal commas,
    Latin-1 and planes at uneven angles; the light output ratio that it states is that of its intensities, rounded."""
    azimuth = [0, 3.5, 7, 11.5, 15.5, 90, 164.5, 168.5, 173, 176.5, 180, 184.5, 188.5, 270, 351.5, 355.5]
    gamma = [0, 78, 81, 84, 87, 90, 93, 96, 99, 102]
    lamps = 3_000

    def candela(c, g):
        def beam(axis):
            off = abs((c - axis + 180) % 360 - 180)
            return max(0, 1 - math.hypot(off, g - 90) / 12)
        return 10_000 * beam(3.5) + 4_000 * beam(176.5)

    per_kilolumen = [[round(candela(c, g) / (lamps / 1000), 2) for g in gamma] for c in azimuth]
    planes = [[value * lamps / 1000 for value in plane] for plane in per_kilolumen]
    total = flux(azimuth + [360], gamma, planes + planes[:1], sin_of_gamma)
    fields = (["litfog", 1, 0, len(azimuth), 0, len(gamma), 0, "14", "Landebahnfeuer wei\xDF/gelb", "", "runway.ldt", "",
               200, 0, 150, 60, 0, 40, 40, 40, 40, 50, f"{100 * total / lamps:.1f}", 1, 0,
               1, 2, "halogen", lamps, "3000 K", "1A", 210] + [0] * 10)
    fields += azimuth + gamma + [value for plane in per_kilolumen for value in plane]
    text = "".join((f if isinstance(f, str) and not f.replace(".", "").isdigit() else str(f).replace(".", ",")) + "\r\n"
                   for f in fields)
    write("runway_edge_light.ldt", text, "latin-1")
    return total, planes[1][5:], [g - 90 for g in gamma[5:]]


def angle_at(profile, angles, fraction):
    """Where a profile that falls from its first sample is a fraction of it."""
    level = fraction * profile[0]
    i = next(i for i, value in enumerate(profile) if value < level)
    return angles[i - 1] + (profile[i - 1] - level) / (profile[i - 1] - profile[i]) * (angles[i] - angles[i - 1])


for lamp in (landing_lamp, approach_light, position_light, runway_edge_light):
    lumens, profile, angles = lamp()
    print(f"{lamp.__name__:18} {lumens:.9g} lm, {max(profile):.9g} cd, half at {angle_at(profile, angles, 0.5):.6f} and "
          f"a tenth at {angle_at(profile, angles, 0.1):.6f} degrees from it")

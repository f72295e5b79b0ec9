# SPDX-License-Identifier: Apache-2.0
"""litfog in Python, with plots: cells for a notebook or an editor that knows them, or a program from end to end.

    python3 apps/examples/python/tour.py [pictures]       from litfog's sources; writes the pictures into that folder
"""

# %% What is needed: Debian's python3-litfog, python3-litfog.pictures for the last cell, and python3-matplotlib.
import pathlib
import sys

import litfog
import matplotlib.pyplot as plt
import numpy as np

lights = pathlib.Path("data/lights")
pictures = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None


def show(name):
    """Shows the figure here, or writes it."""
    if pictures:
        plt.savefig(pictures / f"{name}.png", dpi=110, bbox_inches="tight")
    else:
        plt.show()
    plt.close()


# %% How brightly four lamps light the fog, over the visibility. A batch takes columns: one light or fog a row.
visibilities = np.geomspace(50, 10_000, 400)
densities = litfog.density_from_visibility("exp", visibilities)
for name in ("landing-lamp", "headlight", "street-lamp", "runway-edge"):
    lamp = litfog.read_light(lights / f"{name}.json")
    constant, linear, quadratic = (
        np.full(visibilities.size, value)
        for value in (lamp.attenuation.constant, lamp.attenuation.linear, lamp.attenuation.quadratic)
    )
    seen = lamp.density_scale * densities
    solved = litfog.solve_fog_intensities(constant, linear, quadratic, seen, lamp.threshold)
    airlight = [
        litfog.axial_airlight(lamp.attenuation, litfog.Fog(density=density), lamp.threshold) for density in seen
    ]
    (line,) = plt.semilogx(visibilities, solved.intensity, label=name)
    plt.semilogx(visibilities, airlight, "--", color=line.get_color())
plt.xlabel("visibility, m (contrast 5 %)")
plt.ylabel("fraction of the lamp's colour")
plt.title("fog colour intensity, and airlight along the axis (dashed)")
plt.grid(alpha=0.3)
plt.legend()
show("visibility")

# %% Where the intensity comes from: opacity times attenuation, whose peak the solve finds.
lamp = litfog.read_light(lights / "landing-lamp.json")
fog = litfog.Fog.from_visibility("exp", 1500)
lit = litfog.solve_fog_intensity(lamp, fog)
ranges = np.linspace(0, lit.extent, 500)
attenuation = litfog.attenuation_at(lamp.attenuation, ranges)
opacity = litfog.opacity_at(fog, ranges)
plt.plot(ranges, attenuation, label="attenuation")
plt.plot(ranges, opacity, label="opacity of the fog")
plt.plot(ranges, attenuation * opacity, label="product")
plt.plot(lit.peak_range, lit.intensity, "ko", label=f"{lit.intensity:.3f} at {lit.peak_range:.0f} m")
plt.xlabel("range, m")
plt.title(lamp.name)
plt.grid(alpha=0.3)
plt.legend()
show("peak")

# %% A picture of a lamp's airlight: a ray for each pixel, in one array.
height, width = 240, 400
rays = np.zeros((height, width), litfog.EYE_RAY)
x, y = np.meshgrid(np.linspace(-1, 1, width), np.linspace(0.6, -0.6, height))
directions = np.stack([x, y, -np.ones_like(x)], axis=-1)
rays["origin"] = (0, 1.7, 0)
rays["direction"] = directions / np.linalg.norm(directions, axis=-1, keepdims=True)
below = rays["direction"][..., 1] < 0  # these rays end at the ground
rays["length"] = np.inf
rays["length"][below] = 1.7 / -rays["direction"][..., 1][below]
spot = litfog.Light(attenuation=litfog.Attenuation(1, 0, 0.01), cone=litfog.Cone.smoothstep(0.35, 0.6))
placed = litfog.PlacedLight(spot, position=(0, 8, -12), direction=(0, -1, 0))
figure, axes = plt.subplots(1, 3, figsize=(13, 3))
for axis, metres in zip(axes, (400, 100, 30)):
    airlights = litfog.airlight(placed, litfog.Atmosphere(litfog.Fog.from_visibility("exp", metres)), rays)
    axis.imshow(airlights, cmap="inferno", vmin=0, vmax=0.15)
    axis.set_title(f"visibility {metres} m")
    axis.axis("off")
show("airlight")

# %% From samples of a beam to a cone: the best of all profiles, each the best of its kind.
angles = np.radians([0, 3, 6, 9, 12, 15, 18, 24])
candela = np.array([17000, 16500, 14900, 10200, 5700, 2500, 900, 80])
fit = litfog.fit_cone(angles=angles, intensities=candela)
fine = np.linspace(0, 0.5, 300)
plt.plot(np.degrees(angles), candela / candela.max(), "ko", label="measured")
for profile in fit.profiles:
    name = f"{profile.cone.profile.name}: rms {profile.rms:.3f}"
    plt.plot(np.degrees(fine), litfog.cone_at(profile.cone, np.cos(fine)), label=name)
plt.xlabel("angle from the axis, degrees")
plt.ylabel("fraction of the axial intensity")
plt.title(f"the better cone: {fit.best.cone.profile.name}")
plt.grid(alpha=0.3)
plt.legend()
show("cone")

# %% A scene as litfog-demo draws it, by the papers' formulas and by airlight: arrays of linear light and of what is shown.
import litfog.pictures  # noqa: E402

figure, axes = plt.subplots(1, 3, figsize=(13, 2.8))
pictures_by = {by: litfog.pictures.render("headlights", visibility=100, fog_light=by, size=(400, 225))
               for by in ("peak", "airlight")}  # fmt: skip
for axis, (by, picture) in zip(axes, pictures_by.items()):
    axis.imshow(picture.shown)
    axis.set_title(by)
difference = pictures_by["airlight"].light.mean(2) - pictures_by["peak"].light.mean(2)
shown = axes[2].imshow(difference, cmap="RdBu_r", vmin=-1, vmax=1)
figure.colorbar(shown, ax=axes[2])
axes[2].set_title("airlight less peak, linear")
for axis in axes:
    axis.axis("off")
show("scene")

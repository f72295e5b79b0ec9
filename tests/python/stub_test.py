# SPDX-License-Identifier: Apache-2.0
"""What a user writes, as mypy --strict sees it by the stub; never run."""

import litfog
import numpy as np

fog = litfog.Fog.from_visibility(litfog.FogMode.exp2, 400, contrast=litfog.CONTRAST_KOSCHMIEDER)
fog = litfog.Fog.from_runway_visual_range(fog.mode, 550, illuminance_threshold=litfog.illuminance_threshold(10))
metres: float = litfog.runway_visual_range(fog, candela=5000)
lamp: litfog.Light = litfog.read_light("lamp.json")
peak: float = litfog.solve_fog_intensity(lamp, fog).intensity
for dtype in (np.float32, np.float64):
    column = np.ones(8, dtype)
    out = litfog.BatchSolutions(intensity=np.empty(8))
    invalid: int = litfog.solve_fog_intensities(column, column, column, 0.01, mode=fog.mode, out=out).invalid_count
density = litfog.density_from_visibility(fog.mode, np.array([50.0, 400.0]), contrast=0.02)
litfog.solve_fog_intensities(np.ones(2), np.ones(2), np.ones(2), density)
rays = np.zeros((4, 4), litfog.EYE_RAY)
airlights: np.ndarray[tuple[int, ...], np.dtype[np.float64]] = litfog.airlight(
    litfog.PlacedLight(lamp), litfog.Atmosphere(litfog.Fog("exp2")), rays, "clear"
)
litfog.airlight(litfog.PlacedLight(litfog.read_light(litfog.data_dir)), litfog.Atmosphere(fog), ((0, 0, 0), (0, 0, -1), 5))
beams = litfog.make_thin_beams(litfog.Atmosphere(fog), litfog.make_scattering_table(litfog.Atmosphere(fog)))
litfog.scattering_source(lamp, litfog.Atmosphere(fog), beams).beam.tobytes()
updater = litfog.FogUpdater()
handle: litfog.FogLightHandle = updater.add(litfog.PlacedLight(lamp, carried=True))
for dirty in updater.set_fog(fog).kinds:
    updater.kinds[dirty].tobytes()
covariance = litfog.fit_attenuation(extent=50).covariance
if covariance is not None:
    covariance.trace()
updater.add(litfog.PlacedLight(lamp.replace(threshold=0.02)))
lamp.threshold = 0.02  # type: ignore[misc]
updater.add(lamp)  # type: ignore[arg-type]
litfog.Fog("thick")  # type: ignore[arg-type]
litfog.BatchSolutions(peak_range=np.empty(8))  # type: ignore[call-arg]

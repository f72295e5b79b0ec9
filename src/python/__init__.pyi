# SPDX-License-Identifier: Apache-2.0
# The types of `import litfog`; help() has the texts.
import enum
import os
import pathlib
from collections.abc import Sequence
from typing import Any, Final, Literal, Self, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
data_dir: pathlib.Path
CONTRAST_MOR: float
CONTRAST_KOSCHMIEDER: float
CONTRAST_FLIGHTGEAR: float
DEFAULT_THRESHOLD: float
PHOTOMETRIC_AXIS: tuple[float, float, float]
EYE_RAY: np.dtype[np.void]
THIN_BEAM: np.dtype[np.void]
AXIAL_SAMPLE: np.dtype[np.void]
FOG_LIGHT_KIND: np.dtype[np.void]
FOG_LIGHT_INSTANCE: np.dtype[np.void]
FOG_LIGHT_SOURCE: np.dtype[np.void]

_Path = str | bytes | os.PathLike[str] | os.PathLike[bytes]
_Real = NDArray[np.float64] | NDArray[np.float32]
_Ray = tuple[Sequence[float], Sequence[float], float]
_Rays = NDArray[np.void] | np.void | _Ray | Sequence[_Ray]

class InputError(ValueError):
    file: str
    line: int
    column: int

class OutputError(OSError): ...

# The enumerations, except BatchStatus, have no Python base class, but look like this.
class FogMode(enum.Enum):
    exp = 0
    exp2 = 1

class ConeProfile(enum.Enum):
    none = 0
    cosine = 1
    smoothstep = 2

class SolveStatus(enum.Enum):
    ok = 0
    not_converged = 1

class BatchStatus(enum.IntEnum):
    ok = 0
    not_converged = 1
    invalid = 2

class LampLeg(enum.Enum):
    clear = 0
    fogged = 1

class PhotometryType(enum.Enum):
    a = 0
    b = 1
    c = 2

class AttenuationFamily(enum.Enum):
    quadratic = 0
    linear = 1
    mixed = 2

class AttenuationFitStatus(enum.Enum):
    optimal = 0
    unproven = 1
    infeasible = 2

class ConeFitStatus(enum.Enum):
    optimal = 0
    unproven = 1

_FogMode = FogMode | Literal["exp", "exp2"]
_ConeProfile = ConeProfile | Literal["none", "cosine", "smoothstep"]
_LampLeg = LampLeg | Literal["clear", "fogged"]
_AttenuationFamily = AttenuationFamily | Literal["quadratic", "linear", "mixed"]

class Fog:
    mode: Final[FogMode]
    density: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, mode: _FogMode = ..., density: float = 0.0) -> None: ...
    @staticmethod
    def from_visibility(mode: _FogMode, metres: float, contrast: float = ...) -> Fog: ...
    @staticmethod
    def from_runway_visual_range(
        mode: _FogMode, metres: float, candela: float = 10000.0, illuminance_threshold: float = 8e-07
    ) -> Fog: ...

class PhaseLobe:
    asymmetry: Final[float]
    alpha: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, asymmetry: float = 0.0, alpha: float = 0.0) -> None: ...

class Phase:
    first: Final[PhaseLobe]
    second: Final[PhaseLobe]
    weight: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, first: PhaseLobe = ..., second: PhaseLobe = ..., weight: float = 1.0) -> None: ...
    @staticmethod
    def henyey_greenstein(asymmetry: float) -> Phase: ...
    @staticmethod
    def droplets(micrometres: float) -> Phase: ...

class FogLayer:
    base: Final[float]
    top: Final[float]
    transition: Final[float]
    visibility: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(
        self, base: float = ..., top: float = ..., transition: float = 0.0, visibility: float = ...
    ) -> None: ...

class DensityProfile:
    knots: Final[tuple[tuple[float, float], ...]]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, knots: Sequence[tuple[float, float]] = ...) -> None: ...
    @staticmethod
    def from_layers(layers: Sequence[FogLayer], contrast: float = ...) -> DensityProfile: ...

class Atmosphere:
    fog: Final[Fog]
    phase: Final[Phase]
    albedo: Final[float]
    top: Final[float]
    ambient_fog_color: Final[Sequence[float]]
    profile: Final[DensityProfile]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(
        self,
        fog: Fog = ...,
        phase: Phase = ...,
        albedo: float = 1.0,
        top: float = ...,
        ambient_fog_color: Sequence[float] = ...,
        profile: DensityProfile = ...,
    ) -> None: ...
    def fog_between(self, height_a: float, height_b: float) -> Fog: ...

class Attenuation:
    constant: Final[float]
    linear: Final[float]
    quadratic: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, constant: float = 1.0, linear: float = 0.0, quadratic: float = 0.0) -> None: ...

class Cone:
    profile: Final[ConeProfile]
    half_angle: Final[float]
    exponent: Final[float]
    inner: Final[float]
    outer: Final[float]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(
        self,
        profile: _ConeProfile = ...,
        half_angle: float = 0.0,
        exponent: float = 0.0,
        inner: float = 0.0,
        outer: float = 0.0,
    ) -> None: ...
    @staticmethod
    def cosine(half_angle: float, exponent: float) -> Cone: ...
    @staticmethod
    def smoothstep(inner: float, outer: float) -> Cone: ...

class Flash:
    period: Final[float]
    flashes: Final[tuple[tuple[float, float, float], ...]]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, period: float = 0.0, flashes: Sequence[tuple[float, float, float]] = ...) -> None: ...

class Light:
    name: Final[str]
    color: Final[Sequence[float]]
    attenuation: Final[Attenuation]
    threshold: Final[float]
    cone: Final[Cone]
    density_scale: Final[float]
    source_radius: Final[float]
    flash: Final[Flash]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(
        self,
        name: str = "",
        color: Sequence[float] = ...,
        attenuation: Attenuation = ...,
        threshold: float = ...,
        cone: Cone = ...,
        density_scale: float = 1.0,
        source_radius: float = 0.0,
        flash: Flash = ...,
    ) -> None: ...

def photometric(light: Light | str) -> Light: ...
def candela(light: Light | str) -> Sequence[float]: ...

class PlacedLight:
    light: Final[Light]
    position: Final[Sequence[float]]
    direction: Final[Sequence[float]]
    carried: Final[bool]
    def replace(self, **fields: Any) -> Self: ...
    def __init__(
        self,
        light: Light | str,
        position: Sequence[float] = ...,
        direction: Sequence[float] = ...,
        carried: bool = False,
    ) -> None: ...

class FogIntensity:
    def replace(self, **fields: Any) -> Self: ...
    def __init__(self, intensity: float, peak_range: float, extent: float, status: SolveStatus) -> None: ...
    intensity: Final[float]
    peak_range: Final[float]
    extent: Final[float]
    status: Final[SolveStatus]

class BatchSolutions:
    """Of the results of a solve without `out`, every column is an array."""

    def __init__(
        self,
        intensity: _Real,
        peak_range: _Real | None = None,
        extent: _Real | None = None,
        status: NDArray[np.uint8] | None = None,
    ) -> None: ...
    @property
    def intensity(self) -> Any: ...
    @property
    def peak_range(self) -> Any: ...
    @property
    def extent(self) -> Any: ...
    @property
    def status(self) -> Any: ...
    @property
    def invalid_count(self) -> int: ...

class ScatteringSource:
    intensity: Final[float]
    soft_range: Final[float]
    phase_cosine: Final[float]
    is_cone: Final[bool]
    @property
    def beam(self) -> NDArray[np.float32]: ...

class FogLightHandle: ...

class FogLightChanges:
    kinds: Final[list[slice]]
    instances: Final[list[slice]]
    sources: Final[list[slice]]

class FogUpdateStatistics:
    kinds_solved: Final[int]
    kinds_skipped: Final[int]
    lights_skipped: Final[int]
    bytes_dirty: Final[int]
    sources_solved: Final[int]

class FogUpdater:
    def __init__(self, skip_budget_255: float = 0.5) -> None: ...
    def add(self, light: PlacedLight) -> FogLightHandle: ...
    def change(self, handle: FogLightHandle, light: PlacedLight) -> None: ...
    def switch_light(self, handle: FogLightHandle, is_on: bool) -> None: ...
    def set_time(self, seconds: float) -> None: ...
    def remove(self, handle: FogLightHandle) -> None: ...
    def set_fog(self, fog: Fog) -> FogLightChanges: ...
    def set_atmosphere(self, atmosphere: Atmosphere, eye_height: float = 0.0) -> FogLightChanges: ...
    @property
    def kinds(self) -> NDArray[np.void]: ...
    @property
    def instances(self) -> NDArray[np.void]: ...
    def solve_sources(self) -> None: ...
    @property
    def sources(self) -> NDArray[np.void]: ...
    def instance_of(self, handle: FogLightHandle) -> int: ...
    def kind_of(self, handle: FogLightHandle) -> int: ...
    @property
    def statistics(self) -> FogUpdateStatistics: ...

class IntensityDistribution:
    type: Final[PhotometryType]
    horizontal: Final[NDArray[np.float64]]
    vertical: Final[NDArray[np.float64]]
    intensity: Final[NDArray[np.float64]]

class IntensityPeak:
    intensity: Final[float]
    direction: Final[tuple[float, float, float]]

class Luminaire:
    name: Final[str]
    manufacturer: Final[str]
    distribution: Final[IntensityDistribution]
    lamp_flux: Final[float | None]
    light_output_ratio: Final[float | None]
    is_absolute: Final[bool]

class GldfContainer:
    def __init__(self, path: _Path) -> None: ...
    files: Final[list[str]]
    def read(self, file: str) -> Luminaire: ...

class AttenuationFit:
    attenuation: Final[Attenuation]
    threshold: Final[float]
    status: Final[AttenuationFitStatus]
    sentence: Final[str]
    objective: Final[float]
    rms_error: Final[float]
    largest_error: Final[float]
    residuals: Final[NDArray[np.float64]]
    covariance: Final[NDArray[np.float64] | None]
    kkt_residual: Final[float]

class ConeProfileFit:
    cone: Final[Cone]
    status: Final[ConeFitStatus]
    objective: Final[float]
    lower_bound: Final[float]
    rms: Final[float]
    largest_error: Final[float]
    flux_error: Final[float | None]
    beam_angle_error: Final[float | None]
    field_angle_error: Final[float | None]
    covariance: Final[NDArray[np.float64] | None]

class ConeFit:
    profiles: Final[list[ConeProfileFit]]
    best_index: Final[int]
    best: Final[ConeProfileFit]

def density_from_visibility(mode: _FogMode, metres: ArrayLike, contrast: float = ...) -> Any: ...
def runway_visual_range(fog: Fog, candela: ArrayLike = 10000.0, illuminance_threshold: ArrayLike = 8e-07) -> Any: ...
def illuminance_threshold(background: ArrayLike) -> Any: ...
def attenuation_at(attenuation: Attenuation, range: ArrayLike) -> Any: ...
def fog_factor_at(fog: Fog, range: ArrayLike) -> Any: ...
def opacity_at(fog: Fog, range: ArrayLike) -> Any: ...
def visibility(fog: Fog, contrast: float = ...) -> float: ...
def phase_at(phase: Phase, cosine: ArrayLike) -> Any: ...
def flash_at(flash: Flash, seconds: ArrayLike) -> Any: ...
def cone_at(cone: Cone, cos_angle: ArrayLike) -> Any: ...
def compute_extent(attenuation: Attenuation, threshold: ArrayLike = ...) -> Any: ...
def flux_within(cone: Cone, angle: ArrayLike) -> Any: ...
def angle_at_level(cone: Cone, level: ArrayLike) -> Any: ...
def color_of_temperature(kelvin: ArrayLike) -> Any: ...
@overload
def solve_fog_intensity(attenuation: Attenuation, fog: Fog, threshold: float = ...) -> FogIntensity: ...
@overload
def solve_fog_intensity(light: Light | str, fog: Fog) -> FogIntensity: ...
def solve_fog_intensities(
    constant: ArrayLike,
    linear: ArrayLike,
    quadratic: ArrayLike,
    density: ArrayLike,
    threshold: ArrayLike = ...,
    mode: _FogMode = ...,
    *,
    out: BatchSolutions | None = None,
) -> BatchSolutions: ...
def airlight(
    light: PlacedLight,
    atmosphere: Atmosphere,
    rays: _Rays,
    lamp_leg: _LampLeg = ...,
    *,
    out: NDArray[np.float64] | None = None,
) -> Any: ...
def reference_airlight(
    light: PlacedLight,
    atmosphere: Atmosphere,
    rays: _Rays,
    lamp_leg: _LampLeg = ...,
    *,
    out: NDArray[np.float64] | None = None,
) -> Any: ...
@overload
def axial_airlight(attenuation: Attenuation, fog: Fog, threshold: float = ...) -> float: ...
@overload
def axial_airlight(light: Light | str, fog: Fog) -> float: ...
def light_reach(light: Light | str, fog: Fog, budget: ArrayLike, lamp_leg: _LampLeg = ...) -> Any: ...
def reach_budget(step: float, lights: int, brightness: ArrayLike, atmosphere: Atmosphere) -> Any: ...
def directional_airlight(
    atmosphere: Atmosphere, to_light: Sequence[float], rays: _Rays, *, out: NDArray[np.float64] | None = None
) -> Any: ...
def directional_fog_factor(atmosphere: Atmosphere, to_light: Sequence[float], height: ArrayLike) -> Any: ...
def make_scattering_table(atmosphere: Atmosphere) -> NDArray[np.float32]: ...
def effective_intensity(attenuation: Attenuation, density: ArrayLike) -> Any: ...
def multiple_scattering(
    light: PlacedLight,
    atmosphere: Atmosphere,
    table: NDArray[np.float32],
    rays: _Rays,
    *,
    out: NDArray[np.float64] | None = None,
) -> Any: ...
def make_thin_beams(atmosphere: Atmosphere, table: NDArray[np.float32]) -> NDArray[np.void]: ...
def scattering_source(light: Light | str, atmosphere: Atmosphere, beams: NDArray[np.void]) -> ScatteringSource: ...
def scattered_light(
    light: PlacedLight, source: ScatteringSource, atmosphere: Atmosphere, positions: ArrayLike
) -> NDArray[np.float64]: ...
def irradiance(light: ArrayLike, normal: ArrayLike) -> Any: ...
def read_light(path: _Path) -> Light: ...
def write_light(path: _Path, light: Light | str, source: str | Sequence[str] = ...) -> None: ...
def format_light(light: Light | str, source: str | Sequence[str] = ...) -> str: ...
def read_luminaire(path: _Path) -> Luminaire: ...
def list_gldf(path: _Path) -> list[str]: ...
def stated_flux(luminaire: Luminaire) -> float | None: ...
def luminous_flux(distribution: IntensityDistribution) -> float: ...
def find_peak(distribution: IntensityDistribution) -> IntensityPeak: ...
def axial_profile(distribution: IntensityDistribution, axis: Sequence[float] = ...) -> NDArray[np.void]: ...
def asymmetry(distribution: IntensityDistribution, axis: Sequence[float] = ...) -> float: ...
def fit_attenuation(
    *,
    extent: float | None = None,
    constant: float | None = None,
    ranges: ArrayLike | None = None,
    attenuations: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    threshold: float = ...,
    family: _AttenuationFamily = ...,
    is_robust: bool = False,
) -> AttenuationFit: ...
def fit_cone(
    *,
    profile: _ConeProfile | None = None,
    half_angle: float | None = None,
    beam_angle: float | None = None,
    field_angle: float | None = None,
    angles: ArrayLike | None = None,
    intensities: ArrayLike | None = None,
    weights: ArrayLike | None = None,
) -> ConeFit: ...

# SPDX-License-Identifier: Apache-2.0
# The types of `import litfog.pictures`; help() has the texts.
import os
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple, SupportsFloat

import numpy as np
from numpy.typing import NDArray

_Real = SupportsFloat
_Point = tuple[_Real, _Real, _Real] | list[float] | NDArray[np.floating[Any]] | str

class Unsupported(RuntimeError): ...

class Picture(NamedTuple):
    light: NDArray[np.float32]
    shown: NDArray[np.uint8]
    visibility: float
    exposure: float

def render(
    scene: str | os.PathLike[str],
    *,
    set: Mapping[str, Any] | None = None,
    lamps_only: bool = False,
    lights: int | None = None,
    camera: _Point | None = None,
    target: _Point | None = None,
    fov_deg: _Real | None = None,
    fog: Literal["exp", "exp2", "none"] | None = None,
    visibility: _Real | None = None,
    contrast: Literal["mor", "koschmieder", "flightgear"] | _Real | None = None,
    rvr: _Real | None = None,
    lamp_cd: _Real | None = None,
    background_cd_m2: _Real | None = None,
    threshold_lx: _Real | None = None,
    layers: str | os.PathLike[str] | None = None,
    phase: str | None = None,
    phase_g: _Real | None = None,
    albedo: _Real | None = None,
    path: str | None = None,
    flat_shading: bool = False,
    fog_light: Literal["peak", "airlight"] | None = None,
    scattering: Literal["single", "all"] | None = None,
    shadows: Literal["none", "surfaces", "shafts"] | None = None,
    shadow_lamps: int | None = None,
    shadow_map_size: int | None = None,
    size: tuple[int, int] | str | None = None,
    samples: Literal[1, 2, 4, 8] | None = None,
    map_size: int | None = None,
    cone_maps: Literal["scaled", "even", "one-disc"] | None = None,
    light_ambient: _Real | None = None,
    infinite_viewer: bool = False,
    no_skip: bool = False,
    time: _Real | None = None,
    exposure: Literal["auto"] | _Real | None = None,
    tone: Literal["neutral", "clip"] | None = None,
    glare: Literal["eye", "none"] | None = None,
) -> Picture: ...
def scenes() -> list[str]: ...
def paths() -> list[str]: ...

# SPDX-License-Identifier: Apache-2.0
"""What a user writes, as mypy --strict sees it by the stub of litfog.pictures; never run."""

import pathlib

import litfog.pictures
import numpy as np

picture = litfog.pictures.render("room", visibility=400, size=(640, 360), camera=np.zeros(3), set={"phase_g": 0.5})
red: np.ndarray[tuple[int, ...], np.dtype[np.float32]] = picture.light[..., 0]
light, shown, visibility, exposure = litfog.pictures.render(pathlib.Path("my.json"), exposure="auto", no_skip=True)
litfog.pictures.render("room", fog="fog")  # type: ignore[arg-type]
litfog.pictures.render("room", colour=1)  # type: ignore[call-arg]

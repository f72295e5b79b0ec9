# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel for pip (PEP 517): CMake builds litfog, and installs what is packed."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Called by pip in the sources' folder.

    config_settings  build: the folder to build in, "build" if not given; one that is there keeps its options
    """
    build = (config_settings or {}).get("build", "build")
    options = ["-DLITFOG_BUILD_PYTHON=ON", f"-DPython3_EXECUTABLE={os.path.realpath(sys.executable)}"]
    if not os.path.exists(os.path.join(build, "CMakeCache.txt")):
        options += ["--preset=release", "-DLITFOG_BUILD_TESTS=OFF"]
    run_cmake("-S.", f"-B{build}", *options)
    run_cmake("--build", build, "--target", "litfog_python_package")
    with tempfile.TemporaryDirectory() as prefix:
        for component in ("python3", "pictures", "data"):
            run_cmake("--install", build, "--prefix", prefix, "--component", component)
        return pack(pathlib.Path(prefix), pathlib.Path(wheel_directory))


def run_cmake(*arguments):
    # pip's own PYTHONPATH would hide the packages of the Python that CMake asks.
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run(["cmake", *arguments], check=True, env=environment)


def pack(prefix, folder):
    """Packs the Python package and the data of an install tree. Returns the wheel's name."""
    text = (pathlib.Path(__file__).parents[2] / "CMakeLists.txt").read_text()
    version = re.search(r"^project\(litfog VERSION ([0-9.]+)", text, re.MULTILINE)[1]
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    files = {
        f"litfog-{version}.dist-info/METADATA": f"Metadata-Version: 2.1\nName: litfog\nVersion: {version}\n"
        "Summary: How brightly a light makes fog glow\nLicense: Apache-2.0\nRequires-Dist: numpy\n".encode(),
        f"litfog-{version}.dist-info/WHEEL": "Wheel-Version: 1.0\nGenerator: litfog\nRoot-Is-Purelib: false\n"
        f"Tag: {tag}\n".encode(),
    }
    # The data lies below the environment, from where the package finds it as it does in /usr.
    for source, target in (("lib/python3/dist-packages", "."), ("share/litfog", f"litfog-{version}.data/data/share/litfog")):
        for file in sorted((prefix / source).rglob("*")):
            if file.is_file():
                files[(pathlib.Path(target) / file.relative_to(prefix / source)).as_posix()] = file.read_bytes()
    record = f"litfog-{version}.dist-info/RECORD"
    lines = [f"{name},sha256={digest(content)},{len(content)}\n" for name, content in files.items()]
    files[record] = "".join([*lines, f"{record},,\n"]).encode()
    name = f"litfog-{version}-{tag}.whl"
    with zipfile.ZipFile(folder / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def digest(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()

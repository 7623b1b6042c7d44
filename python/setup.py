"""Builds the compiled half with CMake, in the build folder of the checkout, and installs the package:

    python3 -m venv --system-site-packages VENV
    VENV/bin/pip install --no-build-isolation --no-deps python/
"""
import os
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

CHECKOUT = Path(os.environ.get("AUTOREF_CHECKOUT", Path(__file__).resolve().parent.parent))


class CMakeBuild(build_ext):
    """Builds the CMake target and copies the module to the path that setuptools expects."""

    def build_extension(self, ext: Extension) -> None:
        build = CHECKOUT / "build" / "release"
        subprocess.run(["cmake", "--preset", "release"], cwd=CHECKOUT, check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "autoref_python", "autoref"], check=True)
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        (module,) = (build / "python" / "autoref").glob("_core.*.so")
        shutil.copy(module, target)


setup(packages=["autoref"], ext_modules=[Extension("autoref._core", sources=[])], cmdclass={"build_ext": CMakeBuild})

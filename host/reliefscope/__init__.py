"""reliefscope: a miniature 3D microscope and reflectometer without a moving part."""

import os
from importlib.metadata import PackageNotFoundError, version

# read by OpenMP when numba's kernels first run: threads that spin while they wait take the processor from those they
# wait for, and a busy machine becomes many times slower
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

try:
    __version__ = version("reliefscope")
except PackageNotFoundError:  # run from a source tree that was never installed
    __version__ = "0+unknown"

__all__ = ["__version__"]

"""reliefscope: a miniature 3D microscope and reflectometer without a moving part."""

from importlib.metadata import PackageNotFoundError, version

try:
    __version__ = version("reliefscope")
except PackageNotFoundError:  # run from a source tree that was never installed
    __version__ = "0+unknown"

__all__ = ["__version__"]

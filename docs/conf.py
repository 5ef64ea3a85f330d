"""Sphinx configuration: `make docs` builds the pages into build/docs."""

from importlib.metadata import version as installed_version

project = "reliefscope"
author = "The reliefscope authors"
release = installed_version("reliefscope")
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 3
html_theme = "furo"
html_title = f"reliefscope {release}"
autodoc_typehints = "description"
autodoc_member_order = "bysource"
exclude_patterns = ["build"]
suppress_warnings = ["ref.python", "sphinx_autodoc_typehints"]

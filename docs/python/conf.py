"""Settings of Sphinx: `cargo xtask wheel --test` makes the pages in target/wheel/pages/."""

import slipmode

project = "slipmode"
release = slipmode.__version__
html_title = f"slipmode {release} in Python"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
html_theme = "alabaster"
html_theme_options = {"description": "Rate-and-state friction of a spring-slider", "page_width": "78rem", "body_max_width": "60rem"}
html_show_copyright = False
html_show_sourcelink = False
myst_heading_anchors = 3
autodoc_member_order = "bysource"
toc_object_entries = False
autodoc_typehints = "none"

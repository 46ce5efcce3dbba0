"""Settings of Sphinx: `cargo xtask wheel --pages` makes the site of these pages in target/wheel/pages/."""

import re
from pathlib import Path

import slipmode
from pygments.lexers.special import TextLexer

project = "slipmode"
release = slipmode.__version__
html_title = f"slipmode {release}"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
html_theme = "alabaster"
html_theme_options = {"description": "Rate-and-state friction of a spring-slider", "page_width": "78rem", "body_max_width": "60rem"}
html_show_copyright = False
html_show_sourcelink = False
myst_heading_anchors = 4
autodoc_member_order = "bysource"
toc_object_entries = False
autodoc_typehints = "none"


def with_files(app, name, lines):
    """Have a link to a page outside of `docs` lead to a copy of the file, as links to other files do."""
    folder = Path(app.srcdir, name).parent

    def changed(link):
        is_page = Path(folder, link[1]).resolve().is_relative_to(app.srcdir)
        return link[0] if is_page else f"](path:{link[1]})"

    lines[0] = re.sub(r"\]\(([^):#]+\.md)(#[^)]*)?\)", changed, lines[0])


def setup(app):
    app.add_lexer("csv", TextLexer)
    app.connect("source-read", with_files)

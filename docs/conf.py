"""Sphinx configuration: the chapters of srs/ become pages, all offline."""

import sys
from importlib import metadata
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS / "extensions"))

project = "Tamias2D"
author = "The Tamias2D authors"
version = release = metadata.version("tamias2d")

extensions = ["myst_parser", "sphinx_design", "sphinxcontrib.bibtex", "weave"]
exclude_patterns = ["_static", "extensions"]
source_suffix = {".md": "markdown"}
nitpicky = True
nitpick_ignore_regex = [("py:class", ".*")]  # types in signatures, not all of which are public
python_maximum_signature_line_length = 84
toc_object_entries = False  # each name has its heading
primary_domain = None  # the Python domain would take the fence "property" for itself

myst_enable_extensions = ["attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
bibtex_bibfiles = ["../srs/references.bib"]
bibtex_default_style = "plain"
bibtex_reference_style = "author_year"

html_theme = "furo"
html_title = "Tamias2D"
html_static_path = ["_static"]
html_css_files = ["tamias2d.css"]
html_js_files = ["fit.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#8a3d0f",
        "color-brand-content": "#0b5c82",
    },
    "dark_css_variables": {
        "color-brand-primary": "#f0a36b",
        "color-brand-content": "#77c4e8",
    },
}
pygments_style = "friendly"
pygments_dark_style = "monokai"

mathjax_path = "mathjax/tex-svg-full.js"
mathjax3_config = {
    "svg": {"fontCache": "global"},
    "tex": {"packages": {"[-]": ["require", "autoload"]}},
    "options": {"enableMenu": False},  # its entries would load parts from elsewhere
}

"""Sphinx reads the folder that make/site.py has gathered (this file with it). Nothing on the pages comes from elsewhere."""
import pathlib
import re

from docutils import nodes
from pygments.formatters import HtmlFormatter
from pygments.token import Name, Punctuation, Whitespace
from sphinx.highlighting import PygmentsBridge

project = "stagecraft"
author = ""
html_show_copyright = False
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = "stagecraft"
html_static_path = ["_static"]
html_css_files = ["katex/katex.min.css", "site.css"]
html_js_files = ["katex/katex.min.js", "site.js"]
templates_path = ["_templates"]
doors = ["sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/doors.html",
         "sidebar/scroll-end.html"]
html_sidebars = {"reference/stagecraft/**": doors, "reference/room_*": doors, "gallery/*/**": doors, "source/**": doors}
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
pygments_style = "friendly"
pygments_dark_style = "native"
highlight_language = "none"
nitpicky = True
suppress_warnings = ["myst.header"]  # a README may go from ## to ####


class Coloured(HtmlFormatter):
    """Elements only around what has a colour: half of a page of C++ would be others."""
    def _get_css_classes(self, token):
        return "" if token in (Name, Punctuation, Whitespace) else super()._get_css_classes(token)


PygmentsBridge.html_formatter = Coloured


def without_indentation(app, error):
    """Furo's templates indent, which is a sixth of a small page."""
    for page in [] if error else pathlib.Path(app.outdir).rglob("*.html"):
        if "_static" not in page.relative_to(app.outdir).parts:
            parts = re.split(r"(<(pre|script|textarea)\b.*?</\2>)", page.read_text(), flags=re.S)
            parts[::3] = [re.sub(r"\s*\n\s*", "\n", p) for p in parts[::3]]
            del parts[2::3]
            page.write_text("".join(parts))


def setup(app):
    """Formulas are left as TeX, and rendered in the page by static/site.js with KaTeX."""
    def inline(writer, node):
        writer.body.append(writer.starttag(node, "span", "", CLASS="math") + writer.encode(node.astext()) + "</span>")
        raise nodes.SkipNode

    def display(writer, node):
        writer.body.append(writer.starttag(node, "div", "", CLASS="math") + writer.encode(node.astext()) + "</div>")
        raise nodes.SkipNode

    app.connect("build-finished", without_indentation)
    app.add_html_math_renderer("katex", (inline, None), (display, None))


html_math_renderer = "katex"

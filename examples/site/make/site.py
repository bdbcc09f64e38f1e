"""site.py OUT COMMAND: gathers in OUT all that Sphinx reads, and changes no file there that is as it should be. COMMAND is
build/stagecraft.
"""
import pathlib
import re
import shutil
import sys

import chapters
import gallery
import measured
import pages
import reference

KATEX = pathlib.Path("/usr/share/javascript/katex")
NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
FURO = pathlib.Path("/usr/lib/python3/dist-packages/furo/theme/furo/static")


TITLES = {"about.md": "About <about>"}  # the README's own title is that of the site


def copy_katex(static):
    """The script, the style and of the fonts the one format that every browser of today reads."""
    to = static / "katex"
    (to / "fonts").mkdir(parents=True, exist_ok=True)
    shutil.copy(KATEX / "katex.min.js", to)
    style = (KATEX / "katex.min.css").read_text()
    (to / "katex.min.css").write_text(re.sub(r",url\([^)]*\.(?:woff|ttf)\) format\('[^']*'\)", "", style))
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, to / "fonts")


def mend_furo(static):
    """Debian's style of Furo imports a file from the root of the server, and is dark only where somebody says so. Its script
    imports another one, which no browser does for a page from disk, nor for a script that is no module."""
    shutil.copy(NORMALIZE, static)
    style = re.sub(r"@import url\(/javascript/[^)]*\);", '@import "../normalize.css";', (FURO / "styles/furo.css").read_text())
    dark = re.search(r'body\[data-theme="dark"\] \{(.*?)\}', style, re.S)
    if "prefers-color-scheme" not in style and dark:
        style += f'\n@media not print {{ @media (prefers-color-scheme: dark) {{ body[data-theme="auto"] {{{dark.group(1)}}} }} }}\n'
    (static / "styles").mkdir()
    (static / "styles/furo.css").write_text(style)
    (static / "scripts").mkdir()
    script, gumshoe = ((FURO / "scripts" / name).read_text() for name in ("furo.js", "gumshoe-patched.js"))
    if script.startswith("import"):
        script = gumshoe + script.partition("\n")[2]
    (static / "scripts/furo.js").write_text(script)


def playground(static):
    """A link to the page that examples/playground/run built, where it did; what says how otherwise."""
    built = pages.REPOSITORY / "build/playground/index.html"
    if not built.exists():
        return "A page that judges tableaux in any browser is made by `examples/playground/run`."
    static.mkdir(parents=True, exist_ok=True)
    shutil.copy(built, static / "playground.html")
    return ('<p>Without installing anything: <strong><a href="_static/playground.html">the playground</a></strong> judges a '
            "tableau, draws and asks, in this browser.</p>")


def add_tables_of_contents(out):
    """A page index.md leads to the pages that it links to, in its order; all others belong to no table of contents."""
    listed = set()
    for index in sorted(out.rglob("index.md")):
        text = index.read_text()
        below = [t for t in re.findall(r"\]\(([^)#\s]+\.md)(?:#[^)]*)?\)", text)
                 if (t.endswith("/index.md") and t.count("/") == 1 if index.parent == out else "/" not in t)
                 and not t.startswith("..")]
        if index.parent == out:
            below += ["about.md", "changelog.md"]
        below = [t for t in dict.fromkeys(below) if not (index.parent / t).read_text().startswith("---\norphan")]
        listed |= {(index.parent / t).resolve() for t in below}
        if below:
            index.write_text(text + "\n```{toctree}\n:hidden:\n\n" + "\n".join(TITLES.get(t, t.removesuffix(".md")) for t in below) + "\n```\n")
    for page in out.rglob("*.md"):
        text = page.read_text()
        if page.resolve() not in listed and page != out / "index.md" and not text.startswith("---"):
            page.write_text("---\norphan: true\n---\n" + text)


def bring_up_to_date(new, old):
    """`old` becomes as `new`, and files that are the same keep their times: Sphinx reads again what is younger."""
    for path in sorted(old.rglob("*"), reverse=True) if old.exists() else []:
        if not (new / path.relative_to(old)).exists():
            path.rmdir() if path.is_dir() else path.unlink()
    for path in sorted(new.rglob("*")):
        to = old / path.relative_to(new)
        if path.is_dir():
            to.mkdir(parents=True, exist_ok=True)
        elif not to.exists() or to.read_bytes() != path.read_bytes():
            shutil.copyfile(path, to)
    shutil.rmtree(new)


def main():
    wanted, command = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    out = wanted.with_name(wanted.name + "-new")
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    made, headers, tables = reference.pages(pages.REPOSITORY)
    site = pages.Site(out, command, headers)
    tables["chapters"] = chapters.table(site)
    tables |= measured.tables(site)
    site.generated = tables
    site.page_of |= gallery.pages(site)
    for page, text in made.items():
        site.write(page, text)
    tables["playground"] = playground(out / "_static")
    site.write_all()
    shutil.copytree(pages.SITE / "static", out / "_static", dirs_exist_ok=True)
    shutil.copytree(pages.SITE / "templates", out / "_templates")
    copy_katex(out / "_static")
    mend_furo(out / "_static")
    shutil.copy(pages.SITE / "conf.py", out)
    add_tables_of_contents(out)
    bring_up_to_date(out, wanted)
    print(f"{sum(1 for _ in wanted.rglob('*.md'))} pages gathered")


if __name__ == "__main__":
    main()

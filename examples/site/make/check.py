"""check.py SITE SOURCES: what must hold of the built pages. Prints what does not, and then ends with 1.

- No link is dead, anchors included, and no page loads anything from elsewhere, or a script that is a module.
- Each header that include/README.md names has a page, and each lesson stands on one beside the list of them.
- Each want of SOURCES/wants.txt leads from the front page to its answer in at most two clicks.
- Pictures have an alternative text. All is at most 30 MB.
"""
import html.parser
import os
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__(convert_charrefs=True)
        self.ids, self.links, self.loads, self.no_alt, self.words, self.in_body = set(), [], [], [], [], 0
        self.body_links, self.stack = [], []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        if "id" in a:
            self.ids.add(a["id"])
        if a.get("role") == "main":
            self.in_body = 1
        if tag == "a" and "href" in a:
            self.links.append(a["href"])
            if self.in_body:
                self.body_links.append(a["href"])
        elif tag == "link" and a.get("rel") not in ("canonical", "prev", "next", "index", "search", "genindex"):
            self.loads.append(a.get("href", ""))
        elif tag in ("script", "img", "iframe", "source", "video", "audio", "embed", "object"):
            self.loads += [a[k] for k in ("src", "data", "srcset") if a.get(k)]
            if tag == "img" and not a.get("alt"):
                self.no_alt.append(a.get("src", ""))

    def handle_data(self, data):
        self.words.append(data)

    def text(self):
        return " ".join(" ".join(self.words).split())


def target(page, link):
    """(file, anchor) of a link on a page."""
    parts = urllib.parse.urlsplit(link)
    path = urllib.parse.unquote(parts.path)
    return (page if not path else pathlib.Path(os.path.normpath(page.parent / path))), urllib.parse.unquote(parts.fragment)


def elsewhere(link):
    return re.match(r"(?:https?:)?//", link)


def main():
    site, sources = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    repository, wrong = sources.parents[1], []
    pages = {p: Page(p) for p in site.rglob("*.html")}
    for path, page in pages.items():
        name = path.relative_to(site)
        for link in page.links + page.loads:
            if re.match(r"(?:\w+:)?//|mailto:|data:", link):
                continue
            file, anchor = target(path, link)
            if not file.exists():
                wrong.append(f"{name}: {link} is not there")
            elif anchor and file in pages and anchor not in pages[file].ids:
                wrong.append(f"{name}: {link} has no such anchor")
        wrong += [f"{name} loads {link}" for link in page.loads if elsewhere(link)]
        wrong += [f"{name}: {src} has no alternative text" for src in page.no_alt]
    for script in {target(path, link)[0] for path, page in pages.items() for link in page.loads if link.endswith(".js")}:
        if script.exists() and re.match(r"\s*import\b", script.read_text()):
            wrong.append(f"{script.relative_to(site)} imports a script, which no browser does for a page from disk")
    for style in site.rglob("*.css"):
        for link in re.findall(r"url\(\s*['\"]?([^'\")]+)", style.read_text()) + re.findall(r"@import\s+['\"]([^'\"]+)", style.read_text()):
            if elsewhere(link):
                wrong.append(f"{style.relative_to(site)} loads {link}")
            elif not link.startswith(("data:", "#")) and not target(style, link)[0].exists():
                wrong.append(f"{style.relative_to(site)}: {link} is not there")

    readme = (repository / "include/README.md").read_text()
    tables = "".join(re.findall(r"<!-- headers:.*?<!-- /headers -->", readme, re.S))
    for header in re.findall(r"^\| `([\w/]+\.hpp)`", tables, re.M):
        if site / f"reference/stagecraft/{header.removesuffix('.hpp')}.html" not in pages:
            wrong.append(f"{header} has no page")
    written = " ".join(page.text() for path, page in pages.items() if path.stem != "lessons"
                       and path.relative_to(site).parts[0] in ("tutorials", "howto", "explanation"))
    for lesson in sorted((repository / "examples/lessons").glob("*.cpp")):
        if lesson.name not in written:
            wrong.append(f"{lesson.name} stands on no page")

    front = site / "index.html"
    one = {target(front, link)[0] for link in pages[front].body_links if not elsewhere(link)}
    two = one | {target(p, link)[0] for p in one if p in pages for link in pages[p].body_links if not elsewhere(link)}
    wants = [line for line in (sources / "wants.txt").read_text().split("\n") if line and not line.startswith("#")]
    for line in wants:
        want, answer, words = (part.strip() for part in line.split(" | "))
        page = site / f"{answer}.html"
        if page not in two or page not in pages:
            wrong.append(f"want '{want}': {answer} is not within two clicks of the front page")
        elif words not in pages[page].text():
            wrong.append(f"want '{want}': {answer} does not say '{words}'")

    size = sum(p.stat().st_size for p in site.rglob("*") if p.is_file())
    if size > 30e6:
        wrong.append(f"the site has {size / 1e6:.1f} MB, more than 30")
    print("\n".join(wrong), file=sys.stderr) if wrong else \
        print(f"{len(pages)} pages, {size / 1e6:.1f} MB, {len(wants)} wants answered: no dead link, nothing from elsewhere")
    sys.exit(bool(wrong))


main()

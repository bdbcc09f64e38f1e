"""One page for each published method, each member of a family with at most seven stages, and each pair: what the command says
of it, as text and as pictures. Nothing is typed here but headings.
"""
import concurrent.futures
import json
import os
import re

from reference import escaped

MOST_STAGES = 7
WINDOW = "-6,6,-6,6"  # the same for all, so that pictures compare
KINDS = {"region": "stability region: shaded where abs(R(z)) <= 1",
         "order-star": "order star: shaded where abs(R(z)) > abs(exp(z))",
         "E-polynomial": "E-polynomial: abs(R(iy)) <= 1 where it is not negative"}


def tex(entry):
    """An entry of a file, "(4-sqrt(6))/10", as TeX."""
    text = str(entry).replace(" ", "")

    def inside(text):
        text = re.sub(r"sqrt\(([^()]*)\)", r"\\sqrt{\1}", text)
        return re.sub(r"(?<=[\d})])\*(?=[\\(\d])", r"\\,", text)

    m = re.fullmatch(r"(-?)\(?([^/]*?)\)?/(\d+)", text)
    if m and m.group(2).count("(") == m.group(2).count(")"):
        return f"{m.group(1)}\\tfrac{{{inside(m.group(2))}}}{{{m.group(3)}}}"
    return inside(text)


def array(method):
    """The tableau as a TeX array, where it is small enough to be read."""
    rows, b = method.get("A"), method.get("b")
    if not rows or not b or "form" in method or len(rows) > 8:
        return ""
    entries = [e for row in rows for e in row] + b + method.get("b_embedded", [])
    if max(len(str(e)) for e in entries) > 26 or sum(max(len(str(r[j])) for r in rows) for j in range(len(b))) > 90:
        return ""
    c = method.get("c", [""] * len(rows))

    def line(first, row):
        return " & ".join([tex(first)] + [tex(e) if e not in ("0", 0) else "0" for e in row])

    body = " \\\\[2pt]\n".join(line(ci, row) for ci, row in zip(c, rows)) + " \\\\[2pt] \\hline \\\\[-9pt]\n" + line("", b)
    if "b_embedded" in method:
        body += " \\\\[2pt]\n" + line("", method["b_embedded"])
    return f"$$\n\\begin{{array}}{{c|{'c' * len(rows[0])}}}\n{body}\n\\end{{array}}\n$$\n"


def block(text, language="text"):
    return f"```{language}\n{text}\n```\n"


def pictures(site, page, argument, name, kinds=KINDS):
    out = []
    for kind in kinds:
        said = KINDS[kind]
        window = "" if kind == "E-polynomial" else f" --window={WINDOW}"
        drawn = site.picture(f"stagecraft plot {kind} {argument}{window} -o picture.svg", f"{name}, {said}")
        if drawn:
            out.append(f"![{escaped(name)}, {said}]({os.path.relpath(drawn, os.path.dirname(page))})\n\n*{said}*\n")
    return "\n".join(out)


def method_page(site, path):
    """(page, its text) of a published method."""
    method = json.loads((site.repository / path).read_text())
    page = "gallery/" + re.sub(r"\.json$", ".md", path.removeprefix("tableaux/"))
    several = "form" in method or "partners" in method
    text = [f"---\norphan: true\n---\n# {escaped(method['name'])}\n", "[Gallery](../index.md)\n",
            f"Source: {escaped(method.get('source', 'none given').rstrip('.'))}.\n"]
    if method.get("note"):
        text.append(escaped(method["note"].rstrip(".")) + ".\n")
    tableau = array(method)
    if tableau:
        text += ["## Tableau\n", tableau]
    text += ["## Certificate\n", block(site.run(f"stagecraft certify {path}", {0, 1, 3}))]
    rosenbrock = method.get("form") == "rosenbrock"  # the region only: a picture is as large as a page
    if rosenbrock or not several:
        text += ["## Stability\n", block(site.run(f"stagecraft stability {path}", {0, 1, 3})),
                 "## Pictures\n", pictures(site, page, path, method["name"], ["region"] if rosenbrock else KINDS)]
    text += ["## The file\n", f"`{path}`, for `certify`, `plot` and `read_tableau_file`:\n",
             block((site.repository / path).read_text().rstrip(), "json")]
    return page, "\n".join(text)


def family_page(site, family, s):
    argument = f"{family} {s}"
    title = " ".join(w.upper() if re.fullmatch("i+[abcde]?", w) else w.title() for w in family.split("_"))
    page = f"gallery/families/{family}_{s}.md"
    text = [f"---\norphan: true\n---\n# {title}, s = {s}\n", "[Gallery](../index.md), [families](../families.md)\n",
            "## Certificate\n", block(site.run(f"stagecraft certify {argument}", {0, 1, 3})),
            "## Pictures\n", pictures(site, page, argument, f"{title}, s = {s}"),
            "## Coefficients\n", "Each digit is right.\n", block(site.run(f"stagecraft tableau {argument} --digits 20")),
            "## To copy\n", block(site.run(f"stagecraft tableau {argument} --digits 20 --format json"), "json"),
            block(site.run(f"stagecraft tableau {argument} --format latex"), "latex")]
    return page, "\n".join(text)


def links(table, page_of_name):
    """A Markdown table of the command's whose first column leads to the pages."""
    def one(m):
        page = page_of_name.get(m.group(1).strip())
        return f"| [{escaped(m.group(1).strip())}]({page.removeprefix('gallery/')}) |" if page else m.group()
    return re.sub(r"^\| ([^|]+) \|", one, table, flags=re.M)


def sortable(table):
    return f'<div class="sortable">\n\n{table.strip()}\n\n</div>\n'


def judged(site, paths, page_of):
    """A table of files that the command's own table has no place for."""
    rows = ["| method | form | stages | order | verdict |", "|---|---|---|---|---|"]
    for path in paths:
        method = json.loads((site.repository / path).read_text())
        said = json.loads(site.run(f"stagecraft certify {path} --json", {0, 1, 3}))
        rows.append(f"| [{escaped(said['name'])}]({page_of[path].removeprefix('gallery/')}) | {method.get('form', '')} | "
                    f"{said.get('stages', '')} | {said['order'].get('value', '')} | {said['verdict']} |")
    return "\n".join(rows)


def pages(site):
    """Writes the pages; {file: page} of the methods."""
    names = sorted(str(p.relative_to(site.repository)) for p in (site.repository / "tableaux").glob("*/*.json")
                   if p.parent.name in ("catalogue", "pairs", "dense", "rosenbrock"))
    families = {line.split()[0]: int(re.search(r"s >= (\d+)", line).group(1))
                for line in site.run("stagecraft families").split("\n")}
    members = [(f, s) for f, least in families.items() for s in range(least, MOST_STAGES + 1)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        published = list(pool.map(lambda path: method_page(site, path), names))
        of_families = list(pool.map(lambda m: family_page(site, *m), members))
    for page, text in published + of_families:
        site.write(page, text)
    page_of = {path: page for path, (page, _) in zip(names, published)}
    page_of_name = {json.loads((site.repository / path).read_text())["name"]: page for path, page in page_of.items()}
    table = re.sub(r"\|[^|]*\|$", "|", site.run("stagecraft table tableaux/catalogue"), flags=re.M)  # sources stand on the pages
    site.generated["methods"] = sortable(links(table, page_of_name))
    for folder in "pairs", "dense", "rosenbrock":
        site.generated[folder] = sortable(judged(site, [p for p in names if p.startswith(f"tableaux/{folder}/")], page_of))
    rows = ["| method | order | by |", "|---|---|---|"]
    for (family, s), (page, _) in zip(members, of_families):
        printed = site.run(f"stagecraft certify {family} {s}", {0, 1, 3})
        order = re.search(r"^ *order (\d+)\s+(.*)$", printed, re.M)
        rows.append(f"| [{family} {s}]({page.removeprefix('gallery/')}) | {order.group(1)} | {order.group(2)} |")
    site.generated["families"] = sortable("\n".join(rows))
    return page_of

"""The trees of a lesson's output as pictures, each with what is said of it."""
import re


def positions(levels):
    """(x, y) of each node of a tree by its level sequence: leaves side by side, a node above the middle of its children."""
    children, path = {i: [] for i in range(len(levels))}, []
    for i, level in enumerate(levels):
        path = path[:level]
        if path:
            children[path[-1]].append(i)
        path.append(i)
    place, leaf = {}, 0
    for i in reversed(range(len(levels))):
        below = [place[c][0] for c in children[i]]
        if below:
            x = (min(below) + max(below)) / 2
        else:
            x, leaf = -leaf, leaf + 1
        place[i] = (x, levels[i])
    return place, children


def picture(levels, name):
    place, children = positions(levels)
    left, height = min(x for x, _ in place.values()), max(y for _, y in place.values())
    at = {i: (12 + 22 * (x - left), 12 + 26 * (height - y)) for i, (x, y) in place.items()}
    width = max(x for x, _ in at.values()) + 12
    lines = "".join(f'<path d="M{at[i][0]:g} {at[i][1]:g}L{at[c][0]:g} {at[c][1]:g}"/>' for i in at for c in children[i])
    dots = "".join(f'<circle cx="{x:g}" cy="{y:g}" r="5"/>' for x, y in at.values())
    return (f'<svg class="tree" role="img" xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{26 * height + 24}">'
            f'<title>the tree {name}</title><g stroke="currentColor" stroke-width="1.5">{lines}</g>'
            f'<g fill="currentColor">{dots}</g></svg>')


def table(text):
    rows = ["| tree | written | order | $\\gamma$ | $\\sigma$ | condition |", "|---|---|---|---|---|---|"]
    for block in re.split(r"\n(?=order )", text)[0:]:
        m = re.match(r"order (\d+), tree (\S+), gamma = (\d+), sigma = (\d+)\n((?: +o\n)+) +(.*)\n +(.*)\n", block)
        if m:
            order, name, gamma, sigma, nodes, condition, latex = m.groups()
            levels = [(len(line) - len(line.lstrip()) - 4) // 2 for line in nodes.rstrip("\n").split("\n")]
            rows.append(f"| {picture(levels, name)} | `{name}` | {order} | {gamma} | {sigma} | ${latex}$<br>`{condition}` |")
    return "\n".join(rows)

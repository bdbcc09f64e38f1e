"""Pictures of gnuplot's as pages need them: a title, and no more bytes than can be seen."""
import html
import re


def simplified(points, tolerance):
    """Douglas and Peucker: the points without those nearer to the polygon of the others than the tolerance."""
    keep, todo = {0, len(points) - 1}, [(0, len(points) - 1)]
    while todo:
        a, b = todo.pop()
        (x0, y0), (x1, y1) = points[a], points[b]
        dx, dy = x1 - x0, y1 - y0
        length = dx * dx + dy * dy
        far, at = tolerance * tolerance, None
        for k in range(a + 1, b):
            px, py = points[k][0] - x0, points[k][1] - y0
            t = min(1.0, max(0.0, (px * dx + py * dy) / length)) if length else 0.0
            d = (px - t * dx) ** 2 + (py - t * dy) ** 2
            if d > far:
                far, at = d, k
        if at is not None:
            keep.add(at)
            todo += [(a, at), (at, b)]
    return [points[k] for k in sorted(keep)]


def number(x):
    return f"{x:.1f}".rstrip("0").rstrip(".")


def path(m):
    """The path with as few points; one of curves is left alone."""
    if re.search(r"[^MLZz0-9.,\s-]", m.group(2)):
        return m.group()
    runs = []
    for command, x, y in re.findall(r"([ML]?)\s*(-?[\d.]+),(-?[\d.]+)", m.group(2)):
        if command == "M" or not runs:
            runs.append([])
        runs[-1].append((float(x), float(y)))
    end = "Z" if re.search(r"[Zz]\s*$", m.group(2)) else ""
    text = "".join("M" + "L".join(f"{number(x)},{number(y)}" for x, y in simplified(run, 0.15)) for run in runs)
    return f"{m.group(1)}'{text}{end}'"


def points(m):
    found = [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+),(-?[\d.]+)", m.group(2))]
    return f"{m.group(1)}'{' '.join(f'{number(x)},{number(y)}' for x, y in simplified(found, 0.15))}'"


BAR = re.compile(r"(?:\s*<polygon fill = '([^']*)' points = '([^']*)'/>)")


def chains(rows):
    """Bars, row by row from one side to the other, joined to one polygon for each piece that neither forks nor joins."""
    done, open_chains = [], []
    for row in rows:
        over = [[c for c in open_chains if c[-1][0] < b[1] and b[0] < c[-1][1]] for b in row]
        took = {}
        for bar, below in zip(row, over):
            only = len(below) == 1 and sum(below[0] is c for other in over for c in other) == 1
            chain = below[0] if only else []
            chain.append(bar)
            took[id(chain)] = chain
        done += [c for c in open_chains if id(c) not in took]
        open_chains = list(took.values())
    return done + open_chains


def shaded(m):
    """The bars that fill an area, as polygons."""
    bars, fill = {}, BAR.search(m.group()).group(1)
    for _, text in BAR.findall(m.group()):
        corners = [tuple(map(float, c.split(","))) for c in text.split()]
        xs, ys = {x for x, _ in corners}, {y for _, y in corners}
        if len(xs) != 2 or len(ys) != 2:
            return m.group()
        bars.setdefault(max(ys), []).append((min(xs), max(xs), max(ys), min(ys)))
    text = ""
    for chain in chains([bars[y] for y in sorted(bars, reverse=True)]):
        sides = []
        for side in 0, 1:  # through the middles of the bars' ends, which hides their steps
            ends = [(b[side], (b[2] + b[3]) / 2) for b in chain]
            sides.append([(chain[0][side], chain[0][2])] + simplified(ends, 0.6) + [(chain[-1][side], chain[-1][3])])
        around = sides[0] + sides[1][::-1]
        text += "M" + "L".join(f"{number(x)},{number(y)}" for x, y in around) + "Z"
    return f"<path fill='{fill}' stroke='none' d='{text}'/>"


def slim(svg, title):
    svg = re.sub(r"<title>[^<]*</title>", f"<title>{html.escape(title)}</title>", svg)
    svg = re.sub(r"<desc>.*?</desc>", "", svg, flags=re.S)
    svg = re.sub(r' stroke-linecap="butt"| stroke-linejoin="miter"| font-family="Helvetica"(?= *>)', "", svg)  # said above
    svg = re.sub(r"<tspan *>([^<]*)</tspan>", r"\1", svg)
    drawn = set(re.findall(r"#(gp\w+)", re.sub(r"<defs>.*?</defs>", "", svg, flags=re.S)))
    drawn |= {deep for name in drawn for deep in re.findall(rf"#(gp\w+)' id='{name}'", svg)}
    svg = re.sub(r"\t<(?:path|rect|circle|use)[^>]*\bid='(gp\w+)'[^>]*/>\n", lambda m: m.group() if m.group(1) in drawn else "", svg)
    svg = re.sub(r"\t<filter.*?</filter>\n", lambda m: m.group() if f"#{m.group().split(chr(39))[1]})" in svg else "", svg, flags=re.S)
    svg = re.sub(r"(?:" + BAR.pattern.replace("([^']*)", "[^']*") + "){2,}", shaded, svg)
    svg = re.sub(r"(\bd=)'([^']*)'", path, svg)
    svg = re.sub(r"(\bpoints ?= ?)'([^']*)'", points, svg)
    before = None
    while before != svg:
        before, svg = svg, re.sub(r"<g [^>]*>\s*</g>\s*", "", svg)
    return re.sub(r"[ \t]*\n\s*", "\n", svg)

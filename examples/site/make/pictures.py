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


def area(bars):
    """The outline of bars {top: [(left, right, top, bottom)]} as the data of a path."""
    text = ""
    for chain in chains([bars[y] for y in sorted(bars, reverse=True)]):
        sides = []
        for side in 0, 1:  # through the middles of the bars' ends, which hides their steps
            ends = [(b[side], (b[2] + b[3]) / 2) for b in chain]
            sides.append([(chain[0][side], chain[0][2])] + simplified(ends, 0.6) + [(chain[-1][side], chain[-1][3])])
        around = sides[0] + sides[1][::-1]
        text += "M" + "L".join(f"{number(x)},{number(y)}" for x, y in around) + "Z"
    return text


def shaded(m):
    """The bars that fill areas, as one path for each colour; a line of that colour hides the seam to the next."""
    colours = {}
    for fill, text in BAR.findall(m.group()):
        corners = [tuple(map(float, c.split(","))) for c in text.split()]
        xs, ys = {x for x, _ in corners}, {y for _, y in corners}
        if len(xs) != 2 or len(ys) != 2:
            return m.group()
        colours.setdefault(fill, {}).setdefault(max(ys), []).append((min(xs), max(xs), max(ys), min(ys)))
    stroke = {fill: fill if len(colours) > 1 else "none" for fill in colours}
    return "".join(f"<path fill='{fill}' stroke='{stroke[fill]}' d='{area(bars)}'/>" for fill, bars in colours.items())


GRID = re.compile(r"<g ([^>]*)>\s*<path ([^>]*class=\"gridline\") *d='([^']*)'/>\s*</g>\s*")
TICK = re.compile(r"<g ([^>]*)>\s*<path (stroke='[^']*') *d='([^']*)'/>\s*<g transform=\"translate\(([^,]*),([^)]*)\)\" ([^>]*)>"
                  r"\s*<text(>[^<]*</text>)\s*</g>\s*</g>\s*")


def together(ticks):
    """Ticks of one style: a path, and a group of numbers."""
    style, stroke, said = ticks[0].group(1, 2, 6)
    drawn = "".join(t.group(3) for t in ticks)
    numbers = "".join(f"<text x='{number(float(t.group(4)))}' y='{number(float(t.group(5)))}'{t.group(7)}" for t in ticks)
    return f"<g {style}><path {stroke} d='{drawn}'/></g><g {said}>{numbers}</g>\n"


def axes(svg):
    """Lines of the grid as one path, neighbouring ticks of one style together."""
    lines = list(GRID.finditer(svg))
    if lines:
        drawn = "".join(m.group(3) for m in lines)
        merged = f"<g {lines[0].group(1)}><path {lines[0].group(2)} d='{drawn}'/></g>\n"
        svg = svg[:lines[0].start()] + merged + GRID.sub("", svg[lines[0].start():])
    runs = []
    for m in TICK.finditer(svg):
        if runs and runs[-1][-1].end() == m.start() and runs[-1][0].group(1, 2, 6) == m.group(1, 2, 6):
            runs[-1].append(m)
        else:
            runs.append([m])
    for run in reversed(runs):
        svg = svg[:run[0].start()] + together(run) + svg[run[-1].end():]
    return svg


def slim(svg, title):
    svg = re.sub(r"<title>[^<]*</title>", "", svg)
    svg = re.sub(r"<svg[^>]*>", lambda m: f"{m.group()}\n<title>{html.escape(title)}</title>", svg, count=1)
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
    svg = axes(svg)
    before = None
    while before != svg:
        before, svg = svg, re.sub(r"<g [^>]*>\s*</g>\s*", "", svg)
    return re.sub(r"[ \t]*\n\s*", "\n", svg)

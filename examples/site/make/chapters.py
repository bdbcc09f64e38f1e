"""A page for each program of the examples that draws, as far as it is built: what it prints and its pictures. Whoever built it
waits for it to run; nobody has to build it for the site.
"""
import re
import shutil

PROGRAMS = {  # target, arguments, heading
    "rolling_disc": ("--report {}", "The rolling disc"),
    "thesis": ("--all --svg {}", "The experiments of the thesis, chapter 4"),
    "lecture": ("--all --svg {}", "The lecture, chapters 1 to 3"),
    "boundary_values": ("--all --svg {}", "The lecture, chapters 4 to 6: boundary values"),
}


def title_of(svg, name):
    """What a picture says of itself, else its file's name."""
    m = re.search(r"<title>([^<]+)</title>", svg)
    text = m.group(1) if m and m.group(1) != "Gnuplot" else name
    return re.sub(r"[_\[\]]", " ", text)


def page(site, target, heading, arguments):
    folder = site.work / f"drawn_{target}"
    program = site.command.parent / target
    folder.mkdir(exist_ok=True)
    printed = site.call(f"{program} {arguments.format(folder)}")
    text = [f"---\norphan: true\n---\n# {heading}\n", "[Gallery](../index.md)\n",
            f"By `cmake --build build --target {target}`, then `build/{target} {arguments.format('DIR')}`.\n"]
    (site.out / "pictures" / target).mkdir(parents=True, exist_ok=True)
    for svg in sorted(folder.rglob("*.svg")):
        shutil.copy(svg, site.out / "pictures" / target / svg.name)
        text.append(f"![{title_of(svg.read_text(), svg.stem)}](../../pictures/{target}/{svg.name})\n")
    lines = "\n".join(line for line in printed.stdout.split("\n") if str(folder) not in line)
    text.append(f"## What it prints\n\n````text\n{lines.strip()}\n````\n")
    site.write(f"gallery/chapters/{target}.md", "\n".join(text))


def table(site):
    rows = ["| chapter | |", "|---|---|"]
    for target, (arguments, heading) in PROGRAMS.items():
        if (site.command.parent / target).exists():
            page(site, target, heading, arguments)
            rows.append(f"| [{heading}](chapters/{target}.md) | pictures and numbers |")
        else:
            rows.append(f"| {heading} | not built when these pages were made: `cmake --build build --target {target}` |")
    return "\n".join(rows)

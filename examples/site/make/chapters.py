"""A page for each program of the examples that draws, as far as it is built: what it prints and its pictures. Whoever built it
waits for it to run, once: what it made is kept as long as the program is the same. Nobody has to build it for the site.
"""
import concurrent.futures
import hashlib
import re
import shutil

import pictures

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


def made(site, target, arguments):
    """The folder with the program's pictures and what it printed, `printed.txt`."""
    program = site.command.parent / target
    folder = site.cache / f"{target}_{hashlib.sha256(program.read_bytes()).hexdigest()[:16]}"
    if not folder.exists():
        part = site.work / f"drawn_{target}"
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir()
        printed = site.call(f"{program} {arguments.format(part)}").stdout
        (part / "printed.txt").write_text("\n".join(line for line in printed.split("\n") if str(part) not in line))
        shutil.move(part, folder)
    return folder


def page(site, target, heading, arguments):
    folder = made(site, target, arguments)
    text = [f"---\norphan: true\n---\n# {heading}\n", "[Gallery](../index.md)\n",
            f"By `cmake --build build --target {target}`, then `build/{target} {arguments.format('DIR')}`.\n"]
    drawn = site.out / "pictures" / target
    drawn.mkdir(parents=True, exist_ok=True)
    for path in sorted(folder.rglob("*.svg")):
        svg = path.read_text()
        title = title_of(svg, path.stem)
        (drawn / path.name).write_text(pictures.slim(svg, title) if "GNUPLOT" in svg else svg)
        text.append(f"![{title}](../../pictures/{target}/{path.name})\n")
    text.append(f"## What it prints\n\n````text\n{(folder / 'printed.txt').read_text().strip()}\n````\n")
    site.write(f"gallery/chapters/{target}.md", "\n".join(text))


def table(site):
    built = [target for target in PROGRAMS if (site.command.parent / target).exists()]
    with concurrent.futures.ThreadPoolExecutor() as pool:  # one runs for minutes
        list(pool.map(lambda target: made(site, target, PROGRAMS[target][0]), built))
    rows = ["| chapter | |", "|---|---|"]
    for target, (arguments, heading) in PROGRAMS.items():
        if target in built:
            page(site, target, heading, arguments)
            rows.append(f"| [{heading}](chapters/{target}.md) | pictures and numbers |")
        else:
            rows.append(f"| {heading} | not built when these pages were made: `cmake --build build --target {target}` |")
    return "\n".join(rows)

"""Gathers the pages of the site in a folder that Sphinx reads: those of pages/, the READMEs, one for each header, and what
they show.

A page's source is plain Markdown. What is done to it:
- a paragraph that is a link to a program and no more (`[events.cpp](../../../lessons/events.cpp)`) is followed by the
  program and by what it prints (the file .txt beside it, which a test compares); one that is a link to a section of a
  README, by the programs of that section or, where it has none, by its tables; one that is a link to a header
  (`[options](../include/stagecraft/options.hpp)`), by what the header says of that name;
- the lines of a block `sh` that begin with `stagecraft` are run, and what they print is put below them; a line that ends
  with another exit code than 0 says so: `# exit 1`. What -o writes is shown as a picture;
- links to files of the repository lead to the page made of them;
- a comment `<!-- generated: NAME -->` is replaced by the table of that name.
"""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess

import pictures
import reference
import trees

SITE = pathlib.Path(__file__).resolve().parents[1]
REPOSITORY = SITE.parents[1]

READMES = {
    "README.md": "about.md",
    "include/README.md": "reference/steppers.md",
    "tableaux/README.md": "reference/tableaux.md",
    "theory/README.md": "explanation/verdicts.md",
    "theory/SOURCES.md": "reference/sources.md",
    "theory/BIBLIOGRAPHY.md": "reference/bibliography.md",
    "examples/lessons/README.md": "tutorials/lessons.md",
    "examples/boundary_values/README.md": "explanation/boundary_values.md",
    "examples/every_kind/README.md": "explanation/every_kind.md",
    "examples/extremes/README.md": "explanation/extremes.md",
    "examples/mechanics/README.md": "explanation/mechanics.md",
    "examples/campaign/README.md": "explanation/limits.md",
    "examples/brusselator_2d/README.md": "explanation/large_systems.md",
    "examples/incompressible_flow/README.md": "explanation/incompressible_flow.md",
    "examples/singular_perturbations/README.md": "explanation/singular_perturbations.md",
    "examples/work_precision/README.md": "explanation/work_precision.md",
    "examples/site/README.md": "site.md",
    "CHANGELOG.md": "changelog.md",
    ".github/CONTRIBUTING.md": "contributing.md",
}
LANGUAGE = {".cpp": "cpp", ".hpp": "cpp", ".json": "json", ".yml": "yaml", ".py": "python", ".gp": "gnuplot"}
PROGRAM = re.compile(r"^\[([^\]]+)\]\(([^)\s]+\.(?:cpp|json|txt))\)$", re.M)
HEADER = re.compile(r"^\[(\w+)\]\(([^)\s]+\.hpp)\)$", re.M)
SECTION = re.compile(r"^\[([^\]]+)\]\(([^)\s]+README\.md)#([\w-]+)\)$", re.M)
LINK = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\])\(([^)#\s]*)(#[^)\s]*)?\)")
CODE = re.compile(r"(^ *```.*?^ *```$|(?:^(?: {4,}|\t)[^\n]*\n?)+)", re.M | re.S)


def relative(page, target):
    return os.path.relpath(target, pathlib.PurePosixPath(page).parent)


def slug(heading):
    """The anchor of a heading, as forges and MyST make it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


class Site:
    def __init__(self, out, command, headers):
        self.out, self.command, self.headers = pathlib.Path(out).resolve(), pathlib.Path(command).resolve(), headers
        self.sources = {str(p.relative_to(REPOSITORY)): str(p.relative_to(SITE / "pages"))
                        for p in sorted((SITE / "pages").rglob("*.md"))}
        self.sources |= READMES
        self.page_of = dict(self.sources) | {h: p + ".md" for h, p in headers.items()}
        self.shown = {}  # files of the repository that pages lead to
        self.work = self.out.parent / "site-work"  # where commands are run
        self.work.mkdir(parents=True, exist_ok=True)
        self.cache = self.out.parent / "site-cache"
        self.cache.mkdir(exist_ok=True)
        self.drawn = self.cache / hashlib.sha256(pathlib.Path(pictures.__file__).read_bytes()).hexdigest()[:24]
        self.drawn.mkdir(exist_ok=True)  # pictures, as this make of pictures.py leaves them
        self.repository = REPOSITORY
        self.identity = hashlib.sha256(self.command.read_bytes()).digest()
        for name in ("tableaux", "examples", "tests", "include", "theory"):
            if not (self.work / name).exists():
                (self.work / name).symlink_to(REPOSITORY / name)

    # --- what a command prints ---
    def key(self, line):
        """What the output of a command depends on: itself, and the files that it names."""
        known = hashlib.sha256(self.identity + line.encode())
        for word in re.findall(r"[\w./+-]+", line):
            path = REPOSITORY / word
            if "/" in word and path.exists():
                for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
                    known.update(file.read_bytes() if file.is_file() else b"")
        return known.hexdigest()[:24]

    def call(self, line):
        environment = dict(os.environ, PATH=f"{self.command.parent}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
        return subprocess.run(["bash", "-c", line], cwd=self.work, env=environment, capture_output=True, text=True)

    def run(self, line, expected=None):
        """What it prints. Outputs are kept in `cache`: pages are made anew more often than the command."""
        if expected is None:
            said = re.search(r"#\s*exit (\d)\s*$", line)
            expected = {int(said.group(1) if said else 0)}
        kept = self.cache / (self.key(line) + ".txt")
        if not kept.exists():
            done = self.call(line)
            if done.returncode not in expected:
                raise SystemExit(f"{line}\nended with {done.returncode}: {done.stdout}{done.stderr}")
            kept.write_text((done.stdout + done.stderr).rstrip("\n"))
        return kept.read_text()

    def picture(self, line, title):
        """The page's name of the picture that the command writes by -o; empty where it has none to draw."""
        name = self.key(line) + ".svg"
        kept, refused = self.drawn / name, self.drawn / (name + ".none")
        if not kept.exists() and not refused.exists():
            part = self.work / ("part_" + name)
            done = self.call(re.sub(r"-o \S+", f"-o {part}", line))
            if done.returncode == 0:
                kept.write_text(pictures.slim(part.read_text(), title))
                part.unlink()
            else:
                refused.write_text(done.stderr)
        if refused.exists():
            return ""
        (self.out / "pictures").mkdir(exist_ok=True)
        shutil.copy(kept, self.out / "pictures" / name)
        return f"pictures/{name}"

    def commands(self, page, block):
        lines = re.sub(r"\\\n\s*", "", block).strip().split("\n")
        text, drawn = [], []
        for line in lines:
            line = line.replace("build/stagecraft", "stagecraft")
            if not re.search(r"(^|\| *)stagecraft ", line):
                continue
            if " -o " in line:
                words = re.sub(r"\s*-o \S+|#.*", "", line.split("stagecraft ", 1)[1])
                name = self.picture(re.sub(r"\s*#.*", "", line), words)
                if not name:
                    raise SystemExit(f"{page}: {line} draws nothing")
                drawn.append(f"![{words}]({relative(page, name)})")
                continue
            printed = self.run(line)
            if printed:
                text.append(printed if len(lines) == 1 else f"$ {line}\n{printed}")
        out = "\n\n```text\n" + "\n\n".join(text) + "\n```" if text else ""
        return out + "".join("\n\n" + p for p in drawn)

    # --- programs ---
    def program(self, page, source, name, target):
        path = os.path.normpath(os.path.join(os.path.dirname(source), target))
        text = (REPOSITORY / path).read_text().rstrip()
        if name == "order_conditions.txt":
            return trees.table(text)
        text = re.sub(r"^// SPDX[^\n]*\n", "", text)
        out = f"[{name}]({target}):\n\n```{LANGUAGE.get(pathlib.PurePath(path).suffix, 'text')}\n{text}\n```"
        printed = (REPOSITORY / path).with_suffix(".txt")
        if path.endswith(".cpp") and printed.exists():
            out += f"\n\nIt prints:\n\n```text\n{printed.read_text().rstrip()}\n```"
        return out

    def section(self, source, name, target, anchor):
        path = os.path.normpath(os.path.join(os.path.dirname(source), target))
        parts = re.split(r"^(#+ .*)$", (REPOSITORY / path).read_text(), flags=re.M)
        for heading, body in zip(parts[1::2], parts[2::2]):
            if slug(heading.lstrip("#")) == anchor:
                blocks = re.findall(r"^```(?:cpp|text|sh)\n.*?^```$", body, re.M | re.S)
                if not blocks:
                    return "\n\n".join(re.findall(r"(?:^\|.*\n)+", body, re.M))
                return f"[{name}]({target}#{anchor}):\n\n" + "\n\n".join(blocks)
        raise SystemExit(f"{source}: {target} has no section #{anchor}")

    def header(self, page, source, name, target):
        path = os.path.normpath(os.path.join(os.path.dirname(source), target))
        parts = [(doc, text) for n, _, doc, text in reference.entries((REPOSITORY / path).read_text()) if n == name]
        if not parts:
            raise SystemExit(f"{source}: {target} has no documented {name}")
        said = "\n\n".join(f"{reference.markdown(doc)}\n\n```cpp\n{text}\n```" for doc, text in parts)
        return f"[`{name}`]({target}):\n\n{said}"

    # --- links ---
    def link(self, page, source, match):
        label, target, anchor = match.group(1), match.group(2), match.group(3) or ""
        if not target or re.match(r"\w+:", target):
            return match.group()
        path = os.path.normpath(os.path.join(os.path.dirname(source), target))
        if (REPOSITORY / path).is_dir():
            path = os.path.join(path, "README.md") if path != "." else "README.md"
        if path.startswith("examples/site/pages/") and path not in self.page_of:
            generated = path.removeprefix("examples/site/pages/")
            return f"{label}({relative(page, generated)}{anchor})"
        if path not in self.page_of:
            if not (REPOSITORY / path).exists():
                raise SystemExit(f"{source}: {target} is not there")
            self.shown[path] = "source/" + re.sub(r"[^\w/]", "_", path) + ".md"
            self.page_of[path] = self.shown[path]
        return f"{label}({relative(page, self.page_of[path])}{anchor})"

    def names(self, page, text):
        """`observe/event.hpp` leads to the page of the header."""
        def one(m):
            for root in ("include/stagecraft/", "include/", "tableaux/", "theory/", "theory/stagecraft/theory/"):
                if root + m.group(1) in self.headers:
                    return f"[`{m.group(1)}`]({relative(page, self.headers[root + m.group(1)])}.md)"
            return m.group()
        return re.sub(r"(?<!\[)`((?:\w+/)*\w+\.hpp)`(?!\])", one, text)

    def staged(self, source, page):
        text = (REPOSITORY / source).read_text()
        if source.startswith("examples/site/"):
            text = PROGRAM.sub(lambda m: self.program(page, source, m.group(1), m.group(2)), text)
            text = HEADER.sub(lambda m: self.header(page, source, m.group(1), m.group(2)), text)
            text = SECTION.sub(lambda m: self.section(source, m.group(1), m.group(2), m.group(3)), text)
            text = re.sub(r"^```sh\n(.*?)^```$", lambda m: m.group() + self.commands(page, m.group(1)), text,
                          flags=re.M | re.S)
        text = re.sub(r"<!-- /?(?:headers|rooms|methods|pairs)[^>]*-->\n", "", text)
        generated = re.compile(r"^<!-- generated: (\w+) -->$", re.M)
        pieces = CODE.split(text)
        pieces[::2] = [self.names(page, LINK.sub(lambda m: self.link(page, source, m), p)) for p in pieces[::2]]
        return generated.sub(lambda m: self.generated[m.group(1)], "".join(pieces))

    def write(self, page, text):
        path = self.out / page
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def write_all(self):
        for source, page in self.sources.items():
            self.write(page, self.staged(source, page))
        for path, page in self.shown.items():
            suffix = pathlib.PurePath(path).suffix
            fence = "````" if suffix == ".md" else "```"
            self.write(page, f"---\norphan: true\n---\n# {path.replace('_', chr(92) + '_')}\n\n{fence}{LANGUAGE.get(suffix, 'text')}\n"
                       + (REPOSITORY / path).read_text().rstrip() + f"\n{fence}\n")

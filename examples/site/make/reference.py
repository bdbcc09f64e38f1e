"""One page for each header that has a public documented name, and an index of the names.

The text is that of the `///` comments and the declarations are those of the header, both as they stand there. (Doxygen gives
y' and a < b in comments meanings of its own markup.)
"""
import pathlib
import re

ROOTS = {"include": "include/stagecraft", "tableaux": "tableaux/stagecraft/tableaux",
         "theory": "theory/stagecraft/theory"}
QUOTED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)


def blank(source):
    """The source with comments and quoted text blanked out, every other character in its place."""
    return QUOTED.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), source)


def closing(text, i):
    """The index after the bracket that closes the one at i."""
    depth = 0
    for k in range(i, len(text)):
        depth += (text[k] in "({[") - (text[k] in ")}]")
        if depth == 0:
            return k + 1
    return len(text)


def after_template(text, i):
    """The index after `template <...>` at i, or i."""
    m = re.compile(r"\s*template\s*<").match(text, i)
    if not m:
        return i
    depth, k = 1, m.end()
    while k < len(text) and depth:
        if text[k] in "({[":
            k = closing(text, k)
            continue
        depth += (text[k] == "<") - (text[k] == ">" and text[k - 1] != "-" and text[k - 1] != "=")
        k += 1
    return after_template(text, k)


KIND = re.compile(r"(?:\s*(?:export|inline|typedef|friend|\[\[[^\]]*\]\]))*\s*(struct|class|union|enum(?:\s+class|\s+struct)?|"
                  r"concept|using|namespace)\b")


def after_requires(text, i):
    """The index after a leading requires-clause at i, or i."""
    m = re.compile(r"\s*requires\b\s*").match(text, i)
    if not m:
        return i
    k = m.end()
    while True:
        while k < len(text) and text[k] in "! \n":
            k += 1
        if text.startswith("requires", k):
            k = text.index("{", k)
        elif text[k] != "(":
            k = re.compile(r"[\w:]+\s*(<|)").match(text, k).end()
            depth = 1 if text[k - 1] == "<" else 0
            while depth:
                depth += (text[k] == "<") - (text[k] == ">")
                k += 1
            k -= 1
            text_end = k + 1
        if text[k] in "({":
            text_end = closing(text, k)
        more = re.compile(r"\s*(&&|\|\|)").match(text, text_end)
        if not more:
            return text_end
        k = more.end()


def declaration(text, start):
    """(kind, end of what is shown, end) of the declaration at `start` of blanked text."""
    head = after_requires(text, after_template(text, start))
    m = KIND.match(text, head)
    kind = m.group(1).split()[0] if m else "other"
    k, called = head, False
    while k < len(text):
        c = text[k]
        if c == ";":
            return kind, k + 1, k + 1
        if c == "(":
            k, called = closing(text, k), True
        elif c == "[":
            k = closing(text, k)
        elif c == "=" and kind == "other" and text[k:k + 2] != "==" and text[k - 8:k] != "operator":
            kind = "value" if not called else "other"
            k += 1
        elif c == "{":
            before = text[head:k]
            if kind in ("struct", "class", "union", "enum", "namespace"):
                return kind, k, closing(text, k)
            if kind in ("concept", "using", "value") or not called or re.search(r"requires\s*(\([^{}]*\))?\s*$", before):
                k = closing(text, k)
                continue
            cut = re.search(r"\)\s*(?:noexcept\s*)?:(?!:)", before)
            shown = head + cut.end() - 1 if cut else k
            end = closing(text, k)
            while re.match(r"\s*[,{]", text[end:]):  # members initialised with braces
                end = closing(text, text.index("{", end))
            return "function", shown, end
        else:
            k += 1
    return kind, len(text), len(text)


def synopsis(source, code, start, end, shown):
    """The declaration without the bodies of its functions, and without what is private."""
    kind = declaration(code, start)[0]
    if kind not in ("struct", "class", "union"):
        text = source[start:end if kind == "enum" else shown].rstrip()
        return text if text.endswith(";") else text + ";"
    out, k, public = source[start:shown + 1] + ("\n  public:" if kind == "class" else ""), shown + 1, kind != "class"
    while k < end:
        m = re.compile(r"\s*(public|private|protected)\s*:").match(code, k)
        if m:
            public, k = m.group(1) == "public", m.end()
            continue
        m = re.compile(r"\s*}").match(code, k)
        if m:
            break
        first = re.compile(r"\s*").match(code, k).end()
        _, stop, last = declaration(code, first)
        trailing = re.compile(r"[ ;]*(///<[^\n]*(?:\n\s*///<[^\n]*)*)?").match(source, last)
        comment_to = trailing.end()
        if public:
            text = source[k:first]
            if code[stop - 1] == ";" or stop == last:
                text += source[first:last]
            elif KIND.match(code, after_requires(code, after_template(code, first))):
                text += source[first:last]
            else:
                text += source[first:stop].rstrip() + ";"
            out += text + source[last:comment_to].lstrip(";")
        k = max(comment_to, last)
        k += code[k:k + 1] == ";"
    return re.sub(r"\n{3,}", "\n\n", out.rstrip()) + "\n};"


def name_of(code, start, kind, end):
    head = after_requires(code, after_template(code, start))
    text = code[head:end]
    if kind in ("struct", "class", "union", "enum", "concept", "using"):
        m = re.search(r"(?:struct|class|union|enum(?:\s+class)?|concept|using)\s+(?:\[\[[^\]]*\]\]\s*)?([\w:]+)", text)
        return m.group(1) if m else None
    m = re.search(r"(operator\s*(?:\(\)|[^\s(]+)|[\w:~]+)\s*\(", text) if kind != "value" else None
    if m and "(" in text.split("=")[0]:
        return m.group(1).strip()
    m = re.search(r"([\w:]+)\s*(?:<[^=;{]*>)?\s*(?:\[[^\]]*\]\s*)?(?:=|\{|;)", text)
    return m.group(1) if m else None


def entries(source):
    """(name, kind, docstring, synopsis) of what is documented at namespace scope and not in a namespace detail."""
    code, found, hidden_until = blank(source), [], 0
    for m in re.finditer(r"^namespace (?:\w+::)*(detail|internal)?[^{\n]*\{|^((?:///(?!<)[^\n]*\n)+)", source, re.M):
        if m.start() < hidden_until:
            continue
        if m.group(2) is None:
            if m.group(1):
                hidden_until = closing(code, m.end() - 1)
            continue
        start = re.compile(r"(?:\s*\n)*").match(code, m.end()).end()
        if re.match(r"\s*(namespace|#)", code[start:]):
            continue
        kind, shown, end = declaration(code, start)
        name = name_of(code, start, kind, end)
        text = synopsis(source, code, start, end, shown)
        if name and not re.search(r"detail::(refused|never<|unstated)", text):  # sentences for the compiler to say
            found.append((name, kind, re.sub(r"^/// ?", "", m.group(2), flags=re.M), text))
    return found


def escaped(text):
    """Plain text as Markdown; what stands between backticks stays."""
    parts = re.split(r"(`[^`\n]+`)", text)
    return "".join(p if i % 2 else re.sub(r"([\\*_<>\[\]|$#~{}@^])", r"\\\1", p) for i, p in enumerate(parts))


def markdown(doc):
    """A docstring as Markdown: indented blocks are code, lines with - are lists."""
    out, block, code = [], [], []

    def flush():
        if block:
            out.append("\n".join(escaped(line) if not line.startswith("- ") else "- " + escaped(line[2:]) for line in block))
        block.clear()
        if code:
            text = "\n".join(code).rstrip()
            formula = ";" not in text or re.search(r"[A-Za-z]'(?!\w)", text)  # y' = f
            out.append(f"```{'text' if formula else 'cpp'}\n{text}\n```")
        code.clear()

    for line in doc.rstrip().split("\n"):
        if line.startswith("    ") and (code or not block):
            code.append(line[4:])
        elif not line.strip():
            if code:
                code.append("")
            else:
                flush()
        else:
            if code:
                flush()
            block.append(line if line.startswith("- ") else line.strip())
    flush()
    return "\n\n".join(out)


def first_sentence(doc):
    text = " ".join(doc.split("\n\n")[0].split())
    return re.sub(r"^(.*?[^.]\.) .*$", r"\1", text).rstrip(":.")


def pages(repository):
    """{page: Markdown}, {header: page}, and the tables of all names and rooms."""
    out, of_header, names, rows = {}, {}, [], {}
    for floor, root in ROOTS.items():
        base = repository / root
        for path in sorted(p for p in base.rglob("*.hpp") if not p.stem.endswith("-inl")):  # what nobody includes by hand
            include = str(path.relative_to(repository / floor))
            found = entries(path.read_text())
            if not found:
                continue
            page = "reference/" + include.removesuffix(".hpp")
            of_header[str(path.relative_to(repository))] = page
            room = str(pathlib.PurePath(include).parent)
            by_name = {}
            for name, kind, doc, text in found:
                by_name.setdefault(name, []).append((kind, doc, text))
            up = "../" * (page.count("/"))
            text = [f"---\norphan: true\n---\n# {pathlib.PurePath(include).name}\n",
                    f"[Reference]({up}reference/index.md) / [{room}]({up}reference/room_{room.replace('/', '_')}.md)\n",
                    f"```cpp\n#include <{include}>\n```\n"]
            for name, parts in by_name.items():
                text.append(f"## {escaped(name)}\n")
                names.append((name, parts[0][0], page, include))
                for _, doc, shown in parts:
                    text.append(markdown(doc) + "\n\n```cpp\n" + shown + "\n```\n")
            out[page + ".md"] = "\n".join(text)
            own = [e for e in found if e[0] == path.stem]
            rows.setdefault(room, []).append((include, page, first_sentence((own or found)[0][2]), list(by_name)))
    for room, list_of in rows.items():
        text = [f"---\norphan: true\n---\n# {room}\n", "[Reference](index.md)\n", "| header | what it is | names |", "|---|---|---|"]
        for include, page, sentence, known in list_of:
            link = "../" + page + ".md"
            shown = ", ".join(f"`{n}`" for n in known[:6]) + (" …" if len(known) > 6 else "")
            text.append(f"| [{escaped(include.split('/')[-1])}]({link}) | {escaped(sentence)} | {shown} |")
        out[f"reference/room_{room.replace('/', '_')}.md"] = "\n".join(text) + "\n"
    generated = {}
    text = ["| name | kind | header |", "|---|---|---|"]
    for name, kind, page, include in sorted(names, key=lambda n: (n[0].lower(), n[3])):
        text.append(f"| `{name}` | {'value' if kind == 'other' else kind} | [{escaped(include)}](../{page}.md) |")
    generated["names"] = '<div class="sortable">\n\n' + "\n".join(text) + "\n\n</div>"
    text = ["| room | headers |", "|---|---|"]
    for room, list_of in rows.items():
        text.append(f"| [{escaped(room)}](room_{room.replace('/', '_')}.md) | "
                    + ", ".join(f"[{escaped(i.split('/')[-1].removesuffix('.hpp'))}](../{p}.md)" for i, p, _, _ in list_of) + " |")
    generated["rooms"] = "\n".join(text)
    return out, of_header, generated

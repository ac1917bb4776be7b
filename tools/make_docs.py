#!/usr/bin/env python3
"""Writes the keyword reference from what the program itself says, so that it cannot differ from what it does.

usage: make_docs.py PROGRAM FOLDER     every keyword in full, as `cleave explain` shows it, a page per family
       make_docs.py PROGRAM --pages    the committed pages of docs/keywords: what is honoured, a page per family
       make_docs.py PROGRAM --check    says which committed pages differ from the program (a test)

A family is the first word of a keyword (MAT, BOUNDARY, ...). `./x docs` does the first two.
"""
import json
import re
import subprocess
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / "docs/keywords"
TAKEN = {"honoured": "honoured", "in part": "honoured in part", "output only": "noted and skipped: no influence on the motion",
         "REFUSED": "refused"}


def explain(program, keyword):
    done = subprocess.run([program, "explain", keyword], capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        sys.exit(f"make_docs.py: {program} cannot explain {keyword}:\n{done.stderr}")
    return done.stdout.rstrip()


def families_of(program):
    """{family: {keyword: text of explain}}, both in order of the alphabet."""
    families = {}
    for keyword in sorted(json.loads((ROOT / "data/cards.json").read_text())["keywords"]):
        families.setdefault(keyword.split("_")[0], {})[keyword] = explain(program, keyword)
    return families


def write_reference(families, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for family, members in families.items():
        pages = "".join(f"\n## *{keyword}\n\n```\n{text}\n```\n" for keyword, text in members.items())
        (folder / f"{family.lower()}.md").write_text(f"# *{family}\n{pages}")
    index = "".join(f"- [*{family}]({family.lower()}.md): {len(members)}\n" for family, members in families.items())
    (folder / "README.md").write_text(f"# Keywords\n\n{index}")


def verdict(text):
    """(policy, remark, {heading: fields}) of the lines under 'This program'."""
    said = text[text.rindex("This program: ") + len("This program: "):].splitlines()
    policy, _, remark = said[0].partition("; ")
    fields = {m[1]: m[2] for line in said[1:] if (m := re.match(r"(honoured|no influence|refused): +(.*)", line))}
    return policy, remark, fields


def wrapped(text, hanging=""):
    return textwrap.fill(text, 118, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False) + "\n"


def family_page(family, verdicts):
    """What becomes of each keyword of a family: those that are used one by one, the others in lists."""
    text = f"# *{family}\n"
    for policy in ("honoured", "in part"):
        for keyword, (taken, remark, fields) in verdicts.items():
            if taken != policy:
                continue
            text += f"\n## *{keyword}\n\n" + wrapped(TAKEN[policy].capitalize() + (f"; {remark}." if remark else "."))
            for heading, names in fields.items():
                plain = dict.fromkeys(re.sub(r" \[[^\]]*\]", "", names).split())  # a name may stand on several lines
                text += "\n" + wrapped(f"- {heading}: " + " ".join(f"`{n}`" for n in plain), "  ")
    for policy in ("output only", "REFUSED"):
        remarks = {}
        for keyword, (taken, remark, _) in verdicts.items():
            if taken == policy:
                remarks.setdefault(remark, []).append(f"*{keyword}")
        if remarks:
            text += f"\n## {TAKEN[policy].capitalize()}\n\n"
            text += "".join(wrapped(f"- {', '.join(names)}: {remark}", "  ") for remark, names in sorted(remarks.items()))
    return text


def pages_of(families):
    """{file name: text} of docs/keywords."""
    pages, rows = {}, []
    for family, members in families.items():
        verdicts = {keyword: verdict(text) for keyword, text in members.items()}
        count = {policy: sum(v[0] == policy for v in verdicts.values()) for policy in TAKEN}
        pages[f"{family.lower()}.md"] = family_page(family, verdicts)
        rows.append(f"| [*{family}]({family.lower()}.md) | " + " | ".join(str(n or "") for n in count.values()) + " |\n")
    pages["README.md"] = (
        "# Keywords\n\nWhat the program does with each of the keywords it knows, a page per family. "
        "`cleave explain KEYWORD` shows the\ncolumns, defaults and meanings; `cleave check DECK` says it of a deck. "
        "A deck with a refused keyword runs only with\n`--allow-unsupported`. These pages are written by `./x docs` "
        "from the program, and a test compares them with it.\n\n"
        "| family | honoured | in part | noted only | refused |\n|---|---|---|---|---|\n" + "".join(rows))
    return pages


def main(program, word):
    families = families_of(program)
    if word not in ("--pages", "--check"):
        write_reference(families, Path(word))
        print(f"{sum(map(len, families.values()))} keywords in {len(families)} families: {word}/README.md")
        return 0
    pages = pages_of(families)
    old = {p.name: p.read_text() for p in PAGES.glob("*.md")} if PAGES.is_dir() else {}
    differing = sorted(name for name in pages.keys() | old.keys() if pages.get(name) != old.get(name))
    if word == "--check":
        for name in differing:
            print(f"docs/keywords/{name} does not say what the program does; write it anew with ./x docs")
        return 1 if differing else 0
    PAGES.mkdir(parents=True, exist_ok=True)
    for name in differing:
        (PAGES / name).write_text(pages[name]) if name in pages else (PAGES / name).unlink()
    print(f"docs/keywords: {len(pages)} pages, {len(differing)} changed")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve(), sys.argv[2]))

#!/usr/bin/env python3
"""Checks that the links of every Markdown page lead somewhere, and that every page can be reached.

usage: check_docs.py [ROOT]

A link without a scheme must name a file of the project (and a heading of it, after #). Pages under docs/ must be
linked from docs/README.md, directly, through other pages, or by a link to their folder. Prints each breach as FILE:LINE: TEXT.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from check_layers import project_files, read  # noqa: E402


def anchor(heading):
    """The name that the usual Markdown viewers give a heading."""
    words = re.sub(r"[`*_]|\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def prose(text):
    """(line number, line) outside of code fences."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def links(text):
    for number, line in prose(text):
        for match in re.finditer(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            yield number, match[1]


def check(root):
    breaches, reached_from = [], {}
    pages = [name for name in project_files(root) if name.suffix == ".md"]
    for page in pages:
        for number, link in links(read(root / page)):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, heading = link.partition("#")
            target = (root / page.parent / path).resolve() if path else root / page
            if not target.exists():
                breaches.append(f"{page}:{number}: {link} leads nowhere")
                continue
            reached_from.setdefault(page, set()).add(target)
            if heading and target.suffix == ".md":
                headings = [anchor(m[1]) for _, line in prose(read(target))
                            if (m := re.match(r"#+\s+(.*)", line))]
                if heading not in headings:
                    breaches.append(f"{page}:{number}: {link}: no such heading")
    reached, open_pages = set(), [Path("docs/README.md")]
    while open_pages:
        page = open_pages.pop()
        if page not in reached:
            reached.add(page)
            inside = (t for t in reached_from.get(page, ()) if t.is_relative_to(root))
            for target in inside:
                below = sorted(target.rglob("*.md")) if target.is_dir() else [target]
                open_pages += [t.relative_to(root) for t in below if t.suffix == ".md"]
    for page in pages:
        if page.parts[0] == "docs" and page not in reached:
            breaches.append(f"{page}:1: no page leads here; link it from docs/README.md or a page below it")
    return len(pages), breaches


if __name__ == "__main__":
    count, found = check(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve())
    print("".join(line + "\n" for line in found) + f"{count} pages, {len(found)} breaches")
    sys.exit(1 if found else 0)

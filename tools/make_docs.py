#!/usr/bin/env python3
"""Writes the keyword reference: what the program itself says about every keyword, a page per family.

usage: make_docs.py PROGRAM FOLDER      (./x docs)

A family is the first word of a keyword (MAT, BOUNDARY, ...). The text is that of `cleave explain KEYWORD`, so it
cannot differ from what the program does.
"""
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def explain(program, keyword):
    done = subprocess.run([program, "explain", keyword], capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        sys.exit(f"make_docs.py: {program} cannot explain {keyword}:\n{done.stderr}")
    return done.stdout.rstrip()


def main(program, folder):
    keywords = sorted(json.loads((ROOT / "data/cards.json").read_text())["keywords"])
    families = {}
    for keyword in keywords:
        families.setdefault(keyword.split("_")[0], []).append(keyword)
    folder.mkdir(parents=True, exist_ok=True)
    for family, members in families.items():
        pages = "".join(f"\n## *{keyword}\n\n```\n{explain(program, keyword)}\n```\n" for keyword in members)
        (folder / f"{family.lower()}.md").write_text(f"# *{family}\n{pages}")
    index = "".join(f"- [*{family}]({family.lower()}.md): {len(members)}\n" for family, members in families.items())
    (folder / "README.md").write_text(f"# Keywords\n\n{index}")
    print(f"{len(keywords)} keywords in {len(families)} families: {folder}/README.md")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]))

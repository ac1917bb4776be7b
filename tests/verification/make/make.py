#!/usr/bin/env python3
"""Writes the larger verification decks, each with its expectation: make.py [NAME...]  (default: all
but the large ones of spacetime.py, which are written here on demand)."""
import sys
from pathlib import Path

import bodies
import homogeneous
import spacetime
import statics
import taylor
import walls
import waves

HERE = Path(__file__).resolve().parent.parent
CASES = {**homogeneous.CASES, **waves.CASES, **bodies.CASES, **statics.CASES, **taylor.CASES, **walls.CASES,
         **spacetime.CASES, **spacetime.EXAMPLES}


if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        written = {**CASES, **spacetime.LARGE}[name]()
        folder = HERE.parent / "validation" if name.startswith("taylor") or name in spacetime.VALIDATION else HERE
        if name in spacetime.EXAMPLES:
            folder = HERE.parent.parent / "examples" / name
            folder.mkdir(exist_ok=True)
        elif name in spacetime.LARGE:
            folder = Path(".")
        (folder / (written.name + ".k")).write_text(written.text())
        print(written.name)

#!/usr/bin/env python3
"""Writes examples/NAME/NAME.k as constants of a C++ file: embed_examples.py EXAMPLES OUTPUT."""
import pathlib
import sys

examples, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
decks = sorted(p for p in examples.glob("*/*.k") if p.stem == p.parent.name)
lines = ['// Generated from examples/ by cmake/embed_examples.py.', '#include "app/embedded_examples.hpp"', '',
         'namespace cleave::app {', 'namespace {', '']
for deck in decks:
    # One literal a line: compilers limit the length of one literal, not of what adjacent ones add up to.
    lines.append(f'constexpr char {deck.stem}_text[] =')
    text = deck.read_text().splitlines()
    for row in text:
        escaped = row.replace('\\', '\\\\').replace('"', '\\"')
        lines.append(f'    "{escaped}\\n"')
    lines[-1] += ';'
lines += ['', 'constexpr Example all[] = {'] + [f'    {{"{d.stem}", {{{d.stem}_text, sizeof {d.stem}_text - 1}}}},' for d in decks]
lines += ['};', '', '}  // namespace', '', 'std::span<const Example> embedded_examples() { return all; }', '',
          '}  // namespace cleave::app', '']
output.write_text("\n".join(lines))

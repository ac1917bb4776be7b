#!/usr/bin/env python3
"""Runs decks that carry their own expectation and checks it.

usage: run_decks.py CLEAVE DECK...

Comments at the head of a deck state the case (docs/verification-decks.md has the full description):

  $@ case    one cube pulled along z, linear elastic
  $@ source  closed form, stress = E * strain
  $@ expect  stress_zz element=1 time=1.0  0.21  rel=1e-9 (roundoff)
  $@ expect  summary energy.ratio  1.0  abs=0.01 (model: published ratios lie within 1 %)
  $@ order   displacement_z node=5 exact=0.1 in=1.8..2.2 with=bar_8.k,bar_16.k (order)
  $@ expect-fail "PR must be below 0.5"
  $@ analyse wave_fronts.py
  $@ vary    threads=1,2,3,7 restart=no,57
  $@ options --allow-unsupported
  $@ slow
"""
import csv
import filecmp
import itertools
import json
import math
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

# The history file an entity is looked up in; without an entity it is glstat.
HISTORY = {"element": "elout", "node": "nodout", "part": "matsum", "wall": "rwforc", "support": "spcforc",
           "contact": "rcforc", "body": "rbdout"}
REDUCTIONS = {"max": max, "min": min, "range": lambda v: max(v) - min(v), "peak": lambda v: max(map(abs, v))}
TOLERANCES = ("exact", "roundoff", "order", "model")
DIRECTIVES = ("case", "source", "expect", "expect-fail", "order", "analyse", "vary", "options", "slow")
ANALYSES = Path(__file__).resolve().parent / "analysis"
# What can be varied, with the option of `cleave run` that does it; the value "no" leaves the option out.
# `lanes` takes another program: that of the build with this preset, beside the build of the one given.
VARIABLE = {"threads": "--threads", "restart": "--stop-at-cycle", "lanes": None}
LANES = {"native": "release", "scalar": "scalar"}
REFUSED = (3, 4)  # exit statuses: the deck is at fault, the physics failed; anything else is a crash
LIMIT_S = 900


class Wrong(Exception):
    """What is wrong with a case: its statement, its run or its result."""


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


class Quantity:
    """A scalar named in a deck: NAME [key=value...] [time=T | max | min | range | peak], or summary PATH."""

    def __init__(self, words):
        self.reduction, self.time, self.filters, self.file = None, "end", {}, None
        self.rest = {}      # keys of the caller: rel, abs, exact, in, with, ratio
        self.value = None   # a bare last word, where the caller wants one
        if not words:
            raise Wrong("no quantity is named")
        self.name = words.pop(0)
        if self.name == "summary":
            self.name, self.file = words.pop(0), "summary"
        for word in words:
            key, equals, value = word.partition("=")
            if word in REDUCTIONS:
                self.reduction = word
            elif not equals:
                if self.value is not None:
                    raise Wrong(f"'{word}': one value is expected, it is {self.value} already")
                self.value = word
            elif key in ("rel", "abs", "exact", "in", "with", "ratio"):
                self.rest[key] = value
            elif key == "time":
                self.time = value
            elif key == "file":
                self.file = value
            elif key in HISTORY:
                self.file = self.file or HISTORY[key]
                self.filters["id"] = value
            else:
                self.filters[key] = value
        self.file = self.file or "glstat"

    def __str__(self):
        where = "".join(f" {k}={v}" for k, v in self.filters.items())
        when = "" if self.file == "summary" else f" {self.reduction or 'time=' + self.time}"
        return f"{self.file}: {self.name}{where}{when}"

    def read(self, run):
        """The scalar in a run directory: a float, or a string or truth value of the summary."""
        return self.from_summary(run) if self.file == "summary" else self.from_history(run)

    def from_summary(self, run):
        node = json.loads((run / "summary.json").read_text())
        for step in self.name.split("."):
            if isinstance(node, list) and step.isdigit() and int(step) < len(node):
                node = node[int(step)]
            elif isinstance(node, dict) and step in node:
                node = node[step]
            else:
                known = ", ".join(node) if isinstance(node, dict) else type(node).__name__
                raise Wrong(f"summary.json has no {self.name}: at '{step}' there is {known}")
        return node

    def from_history(self, run):
        path = run / f"{self.file}.csv"
        if not path.is_file():
            raise Wrong(f"the run wrote no {path.name}; does the deck ask for it?")
        with path.open(newline="") as stream:
            rows = csv.DictReader(stream, skipinitialspace=True)
            names = rows.fieldnames or []
            for name in (self.name, "time", *self.filters):
                if name not in names:
                    raise Wrong(f"{path.name} has no column {name}; it has {', '.join(names)}")
            points = [(float(r["time"]), float(r[self.name])) for r in rows
                      if all(same(r[k], v) for k, v in self.filters.items())]
        if not points:
            raise Wrong(f"{path.name} has no row with {self.filters}")
        if self.reduction:
            return REDUCTIONS[self.reduction]([value for _, value in points])
        return points[-1][1] if self.time == "end" else at_time(points, float(self.time), path.name)


def same(written, wanted):
    """Equal as text or as numbers, so that an id may be written 1 or 1.0."""
    return written == wanted or (number(wanted) is not None and number(written) == number(wanted))


def at_time(points, time, name):
    """Value at a time, linear between rows; past the last row by more than 1 % of the run it is an error."""
    first, last = points[0], points[-1]
    slack = 0.01 * (last[0] - first[0])
    if not first[0] - slack <= time <= last[0] + slack:
        raise Wrong(f"{name} runs from {first[0]} to {last[0]}, it has no time {time}")
    for (t0, v0), (t1, v1) in zip(points, points[1:]):
        if t0 <= time < t1:
            return v0 + (v1 - v0) * (time - t0) / (t1 - t0)
    return first[1] if time < first[0] else last[1]


class Case:
    """The directives of one deck."""

    def __init__(self, deck):
        self.deck = deck
        self.text, self.expects, self.orders, self.failures = "", [], [], []
        self.variations, self.options, self.analyses = [{}], [], []
        with deck.open(encoding="latin-1") as stream:
            for line_number, line in enumerate(stream, 1):
                if line.startswith("$@"):
                    try:
                        self.directive(line[2:].strip())
                    except (Wrong, ValueError, IndexError) as error:
                        raise Wrong(f"{deck}:{line_number}: {error}") from None
        if not self.expects and not self.orders and not self.failures:
            raise Wrong(f"{deck}: states no expectation")

    def directive(self, text):
        word, _, rest = text.partition(" ")
        rest = rest.strip()
        if word not in DIRECTIVES:
            raise Wrong(f"'$@ {word}' is not known; there are {', '.join(DIRECTIVES)}")
        if word == "case":
            self.text = rest
        elif word == "expect-fail":
            self.failures += shlex.split(rest)
        elif word == "analyse":
            self.analyses.append(shlex.split(rest))
        elif word == "options":
            self.options += shlex.split(rest)
        elif word == "vary":
            choices = [(k, v.split(",")) for k, _, v in (w.partition("=") for w in rest.split())]
            words_of(dict(choices))
            values = itertools.product(*(v for _, v in choices))
            self.variations = [dict(zip((k for k, _ in choices), v)) for v in values]
        elif word == "expect":
            self.expects.append(Expectation(rest))
        elif word == "order":
            self.orders.append(Order(rest))


def split_reason(text):
    """'... (name: words)' -> text before, tolerance name."""
    match = re.search(r"\((\w+)(?::[^()]*(?:\([^()]*\)[^()]*)*)?\)\s*$", text)
    if not match or match[1] not in TOLERANCES:
        raise Wrong(f"end the line with the name of the tolerance in brackets: {', '.join(TOLERANCES)}")
    return text[:match.start()], match[1]


class Expectation:
    def __init__(self, text):
        text, self.tolerance = split_reason(text)
        self.quantity = q = Quantity(shlex.split(text))
        if q.value is None:
            raise Wrong("no value is expected")
        self.value = number(q.value)
        self.relative, self.absolute = float(q.rest.get("rel", 0)), float(q.rest.get("abs", 0))
        if (self.tolerance == "exact") == bool(self.relative or self.absolute):
            raise Wrong("'exact' takes no rel= or abs=, every other tolerance needs one")

    def check(self, run):
        """(holds, line for the reader)"""
        got = self.quantity.read(run)
        if isinstance(got, (bool, str)) or got is None or self.value is None:
            text = json.dumps(got) if isinstance(got, bool) or got is None else str(got)
            return text == self.quantity.value, f"{self.quantity} = {text}, expected {self.quantity.value}"
        allowed = self.absolute + self.relative * abs(self.value)
        off = abs(got - self.value)
        line = f"{self.quantity} = {got:.10g}, expected {self.value:.10g}, off by {off:.3g}"
        if self.tolerance == "exact":
            return got == self.value, line + " (exact)"
        return off <= allowed, f"{line}, allowed {allowed:.3g} ({self.tolerance})"


class Order:
    """Errors on a row of meshes, each finer by the same ratio, fall with a power inside a window."""

    def __init__(self, text):
        text, self.tolerance = split_reason(text)
        self.quantity = q = Quantity(shlex.split(text))
        self.exact, self.ratio = float(q.rest["exact"]), float(q.rest.get("ratio", 2))
        self.low, self.high = (float(v) for v in q.rest["in"].split(".."))
        self.finer = q.rest["with"].split(",")
        if len(self.finer) < 2:
            raise Wrong("an order needs at least three meshes: with= names two or more")

    def check(self, runs):
        errors = [abs(self.quantity.read(run) - self.exact) for run in runs]
        print(f"    {self.quantity}, exact {self.exact:g}\n    mesh      error   order")
        holds = True
        for i, error in enumerate(errors):
            order = math.log(errors[i - 1] / error, self.ratio) if i and error and errors[i - 1] else None
            print(f"    {i:4d} {error:10.3e}" + (f"  {order:6.3f}" if order is not None else ""))
            holds = holds and (i == 0 or (order is not None and self.low <= order <= self.high))
        return holds, f"order of {self.quantity} within {self.low:g}..{self.high:g}"


def words_of(variation):
    """The words a variation adds to `cleave run`."""
    words = []
    for key, value in variation.items():
        if key not in VARIABLE:
            raise Wrong(f"cannot vary '{key}'; {' and '.join(VARIABLE)} can be varied")
        if VARIABLE[key] and value != "no":
            words += [VARIABLE[key], value]
    return words


def program_for(variation, program):
    """The program of a variation of the lanes, None where its build does not exist."""
    lanes = variation.get("lanes")
    if lanes is None:
        return program
    if lanes not in LANES:
        raise Wrong(f"lanes={lanes}: there are {' and '.join(LANES)}")
    twin = program.parent.parent / LANES[lanes] / program.name
    return twin if twin.is_file() else None


def call(program, *words):
    """Runs the program; returns (exit status, everything it said)."""
    try:
        done = subprocess.run([program, *words], capture_output=True, timeout=LIMIT_S)
    except subprocess.TimeoutExpired:
        raise Wrong(f"still running after {LIMIT_S} s") from None
    return done.returncode, (done.stdout + done.stderr).decode(errors="replace")


def must_run(program, deck, directory, variation, options):
    """Runs the deck to its end, by way of a stop and a restart where the variation says so."""
    status, said = call(program, "run", deck, "-o", directory, *words_of(variation), *options)
    if status == 0 and variation.get("restart", "no") != "no":
        status, said = call(program, "restart", directory)
    if status != 0:
        raise Wrong(f"the run ended with status {status}:\n{said[-4000:]}")


def analyse(run, deck, words):
    """Lets a script of tests/analysis measure a run; it leaves further histories in the run directory."""
    script = ANALYSES / words[0]
    if not script.is_file():
        raise Wrong(f"there is no analysis {words[0]} in {ANALYSES}")
    done = subprocess.run([sys.executable, script, run, deck, *words[1:]], capture_output=True, text=True, timeout=LIMIT_S)
    if done.returncode != 0:
        raise Wrong(f"{words[0]} ended with status {done.returncode}:\n{(done.stdout + done.stderr)[-4000:]}")
    print(done.stdout, end="")


def same_histories(first, second):
    """Every CSV of both runs, byte for byte."""
    names = sorted(p.name for p in first.glob("*.csv"))
    if not names:
        raise Wrong("the run wrote no CSV to compare")
    if names != sorted(p.name for p in second.glob("*.csv")):
        return names
    return [n for n in names if not filecmp.cmp(first / n, second / n, shallow=False)]


def check(program, deck):
    """Prints what was checked; returns whether all of it holds."""
    case = Case(deck)
    print(f"{deck}: {case.text}")
    results = []
    with tempfile.TemporaryDirectory() as folder:
        runs = []
        for variation in case.variations:
            twin = program_for(variation, program)
            if twin is None:
                print(f"  note lanes={variation['lanes']} not compared: ./x build {LANES[variation['lanes']]} cleave")
                continue
            run = Path(folder) / ("run" + "".join(f"_{k}{v}" for k, v in variation.items()))
            if case.failures:
                status, said = call(twin, "run", deck, "-o", run, *words_of(variation), *case.options)
                results.append((status in REFUSED, f"refused (status {status})"))
                results += [(text in said, f'says "{text}"') for text in case.failures]
                if not all(holds for holds, _ in results):
                    print(said[-4000:])
                continue
            must_run(twin, deck, run, variation, case.options)
            runs.append(run)
            if len(runs) > 1:
                differing = same_histories(runs[0], run)
                results.append((not differing, f"{run.name} has the bits of {runs[0].name} {' '.join(differing)}"))
        if not runs and not case.failures:
            raise Wrong("no variation could run")
        for words in case.analyses:
            analyse(runs[0], deck, words)
        for expectation in case.expects:
            results.append(expectation.check(runs[0]))
        finer = {}
        for order in case.orders:
            for name in order.finer:
                if name not in finer:
                    finer[name] = Path(folder) / name
                    must_run(program, deck.parent / name, finer[name], case.variations[0], case.options)
            results.append(order.check([runs[0], *(finer[name] for name in order.finer)]))
    for holds, line in results:
        print("  ok  " if holds else "  FAIL", line)
    return all(holds for holds, _ in results)


def main(arguments):
    program, *decks = arguments
    good = True
    for deck in decks:
        try:
            good = check(Path(program).resolve(), Path(deck).resolve()) and good
        except Wrong as error:
            print(f"  FAIL {error}")
            good = False
    return 0 if good else 1


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))

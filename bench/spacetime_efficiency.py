#!/usr/bin/env python3
"""Error against cost of the spacetime method's local spaces, as a table and a figure.

usage: spacetime_efficiency.py BENCH_DIRECTORY FIGURE.svg [--spectral SEM2D.cpp] [--end TIME] [--longest SECONDS] [--repeat]

BENCH_DIRECTORY holds the built programs. With --spectral the reference is compiled in a scratch folder and run on the
same standing wave. Costs at equal error are interpolated between meshes on logarithmic scales.
"""
import argparse
import math
import re
import subprocess
import tempfile
from pathlib import Path

COLOUR = {"one_field": "#b3541e", "three_fields": "#1f5a8a", "trefftz": "#2f7d32", "spectral": "#555555"}
NAME = {"one_field": "one field", "three_fields": "three fields", "trefftz": "Trefftz", "spectral": "spectral elements"}


def study(program, end, longest, repeat):
    """{(space, degree): [(seconds, energy error, microseconds per patch)]}"""
    lines = []
    for space in "012":
        words = [program, str(end), str(longest), "1" if repeat else "0", space]
        lines += subprocess.run(words, check=True, capture_output=True, text=True).stdout.split("\n")[1:]
    runs = {}
    for line in filter(None, lines):
        space, degree, _, _, us, seconds, _, energy, momentum, balance = line.split()
        if float(momentum) > 1e-12 or float(balance) > 1e-10:
            raise SystemExit(f"identities are violated: {line}")
        runs.setdefault((space, int(degree)), []).append((float(seconds), float(energy), float(us)))
    return runs


def spectral(source, end, finest=1):
    """[(n, seconds, displacement error)] of order 4 in space and time; the step is that of elements `finest` times smaller"""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "sem"
        subprocess.run(["c++", "-O3", "-march=native", "-o", program, source], check=True)
        points = []
        for n in (4, 6, 8, 12, 16, 24):
            tries = [subprocess.run([program, "4", str(n), str(end), str(0.9 / finest), "4"], check=True, capture_output=True, text=True).stdout
                     for _ in range(5 if finest == 1 else 1)]
            seconds = sorted(float(re.search(r"cpu=([\d.e+-]+)", t)[1]) for t in tries)[len(tries) // 2]
            points.append((n, seconds, float(re.search(r"relL2=([\d.e+-]+)", tries[0])[1])))
        return points


def cost_at(points, error):
    """Seconds at an energy error, between two runs; None outside them."""
    for (s0, e0, _), (s1, e1, _) in zip(points, points[1:]):
        if e1 <= error <= e0:
            share = math.log(e0 / error) / math.log(e0 / e1)
            return math.exp(math.log(s0) + share * math.log(s1 / s0))
    return None


def figure(runs, path):
    width, height, left, bottom = 720, 460, 70, 50
    points = [p for series in runs.values() for p in series if p[1] < 0.9]
    x0, x1 = (math.log10(f(p[0] for p in points)) for f in (min, max))
    y0, y1 = (math.log10(f(p[1] for p in points)) for f in (min, max))
    sx = lambda s: left + (math.log10(s) - x0) / (x1 - x0) * (width - left - 90)
    sy = lambda e: 20 + (y1 - math.log10(e)) / (y1 - y0) * (height - bottom - 30)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
           f'<rect width="{width}" height="{height}" fill="white"/>']
    for k in range(math.ceil(x0), math.floor(x1) + 1):
        x = sx(10.0**k)
        out.append(f'<path d="M{x:.1f} 20V{height - bottom}" stroke="#ddd"/><text x="{x:.1f}" y="{height - 32}" text-anchor="middle">1e{k}</text>')
    for k in range(math.ceil(y0), math.floor(y1) + 1):
        y = sy(10.0**k)
        out.append(f'<path d="M{left} {y:.1f}H{width - 90}" stroke="#ddd"/><text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">1e{k}</text>')
    for (space, degree), series in sorted(runs.items()):
        shown = [(sx(s), sy(e)) for s, e, _ in series if e < 0.9]
        line = "L".join(f"{x:.1f} {y:.1f}" for x, y in shown)
        out.append(f'<path d="M{line}" fill="none" stroke="{COLOUR[space]}" stroke-width="1.6"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{COLOUR[space]}"/>' for x, y in shown]
        out.append(f'<text x="{shown[-1][0] + 6:.1f}" y="{shown[-1][1] + 4:.1f}" fill="{COLOUR[space]}">{degree}</text>')
    for i, space in enumerate(("one_field", "three_fields", "trefftz")):
        out.append(f'<text x="{width - 210}" y="{40 + 18 * i}" fill="{COLOUR[space]}">{NAME[space]}, degree p of v, E</text>')
    out.append(f'<text x="{(width - 20) / 2}" y="{height - 8}" text-anchor="middle">seconds, one thread</text>')
    out.append(f'<text transform="translate(16 {height / 2 - 10}) rotate(-90)" text-anchor="middle">relative error in energy norm</text>')
    path.write_text("\n".join(out) + "\n</svg>\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bench", type=Path)
    parser.add_argument("figure", type=Path)
    parser.add_argument("--spectral", type=Path)
    parser.add_argument("--end", type=float, default=0.5)
    parser.add_argument("--longest", type=float, default=3.0)
    parser.add_argument("--repeat", action="store_true", help="tents repeat and share their operators")
    args = parser.parse_args()
    runs = study(args.bench / "bench_spacetime_efficiency", args.end, args.longest, args.repeat)
    figure(runs, args.figure)
    print("| p | us a patch: one field | three fields | Trefftz | at energy error | one / three fields | three fields / Trefftz |")
    print("|---|---|---|---|---|---|---|")
    for p in sorted({degree for _, degree in runs}):
        one, three, trefftz = (runs[(space, p)] for space in ("one_field", "three_fields", "trefftz"))
        # The smallest error that all three have reached.
        error = max(series[-1][1] for series in (one, three, trefftz)) * 1.0001
        cost = [cost_at(series, error) for series in (one, three, trefftz)]
        # The finest mesh on which all were run.
        mesh = min(map(len, (one, three, trefftz))) - 1
        print(f"| {p} | {one[mesh][2]:.0f} | {three[mesh][2]:.0f} | {trefftz[mesh][2]:.0f} | {error:.1e} | "
              f"{cost[0] / cost[1]:.1f} | {cost[1] / cost[2]:.1f} |")
    if args.spectral:
        print("\nspectral elements of degree 4, order 4 in time, to time 2: n, seconds, displacement error")
        for finest in (1, 20, 32):
            print(f"steps of elements {finest} times smaller:")
            for n, seconds, error in spectral(args.spectral, 2.0, finest):
                print(f"{n:3d} {seconds:.4f} {error:.2e}")


if __name__ == "__main__":
    main()

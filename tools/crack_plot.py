#!/usr/bin/env python3
"""Draws the opening of crack_step against the exact one: crack_plot.py RUN OUT.svg"""
import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/verification/make"))
from crack import StepLoadedCrack  # noqa: E402
from spacetime_basics import speed_d  # noqa: E402
from spacetime_cracks import STEEL  # noqa: E402


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    rows = {}
    for row in csv.DictReader(open(Path(sys.argv[1]) / "nodout.csv")):
        rows.setdefault(row["id"], []).append(row)
    # By where they were at first; the others are there for K.
    rows = {node: history for node, history in rows.items() if -float(history[0]["x_coordinate"]) in (0.125, 0.25, 0.5, 1.0)}
    c = speed_d(**STEEL)
    arrival, velocity, exact = 2.0 / c, 500.0e6 / (STEEL["density"] * c), StepLoadedCrack(STEEL["poisson"])
    width, height, left, bottom = 640, 360, 60, 40
    x = lambda t: left + (width - left - 20) * (t / arrival - 1) / 2
    y = lambda u: height - bottom - (height - bottom - 20) * u / 6.5e-3
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           f'<path d="M{left} 20V{height - bottom}H{width - 20}" fill="none" stroke="#444"/>']
    for k in range(0, 9):
        t = (1 + k / 4) * arrival
        out.append(f'<text x="{x(t):.0f}" y="{height - bottom + 16}" text-anchor="middle">{1 + k / 4:g}</text>')
    for u in range(0, 7, 2):
        out.append(f'<text x="{left - 6}" y="{y(u * 1e-3) + 4:.0f}" text-anchor="end">{u}</text>')
    out.append(f'<text x="{(width + left) / 2}" y="{height - 6}" text-anchor="middle">time over arrival of the wave</text>')
    out.append(f'<text x="14" y="{height / 2}" text-anchor="middle" transform="rotate(-90 14 {height / 2})">'
               'displacement of the face, mm</text>')
    colours = ["#440154", "#31688e", "#35b779", "#b5a300"]
    for colour, (node, history) in zip(colours, sorted(rows.items(), key=lambda p: -float(p[1][0]["x_coordinate"]))):
        r = -float(history[0]["x_coordinate"])
        points = []
        for k in range(1, 101):
            t = arrival * 2 * k / 100
            points.append(f"{x(arrival + t):.1f} {y(velocity * t * exact.displacement(c * t / r)):.1f}")
        out.append(f'<path d="M{left} {y(0):.1f}L{" ".join(points)}" fill="none" stroke="{colour}" stroke-width="1.3"/>')
        for row in history:
            t = float(row["time"])
            if t > arrival and round(t / arrival * 40) % 4 == 0:
                out.append(f'<circle cx="{x(t):.1f}" cy="{y(float(row["y_displacement"])):.1f}" r="3" fill="{colour}"/>')
        top = y(velocity * 2 * arrival * exact.displacement(2 * c * arrival / r))
        out.append(f'<text x="{width - 24}" y="{top - 8:.0f}" text-anchor="end" fill="{colour}">r = {r:g} m</text>')
    Path(sys.argv[2]).write_text("\n".join(out + ["</svg>", ""]))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Draws stress intensity over time against published values: intensity_plot.py CENTRE PUSHED PENNY OUT.svg

Runs of spacetime_centre_crack, spacetime_pushed_crack and spacetime_pushed_penny (tests/validation), or of the finer decks."""
import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/verification/make"))
from crack import intensity  # noqa: E402
from spacetime_intensity import CHEN, PENNY  # noqa: E402


def history(run, time, unit):
    """Of the first tip: (time, K) over their units."""
    rows = list(csv.DictReader(open(Path(run) / "crack_tip.csv")))
    return [(float(r["time"]) / time, float(r["K_I"]) / unit) for r in rows if r["id"] == rows[0]["id"]]


class Panel:
    def __init__(self, out, left, across, up, words, ticks):
        self.out, self.left, self.across, self.up = out, left, across, up
        out.append(f'<path d="M{left} 20V300H{left + 300}" fill="none" stroke="#444"/>')
        for t in ticks[0]:
            out.append(f'<text x="{self.x(t):.0f}" y="316" text-anchor="middle">{t:g}</text>')
        for k in ticks[1]:
            out.append(f'<text x="{left - 6}" y="{self.y(k) + 4:.0f}" text-anchor="end">{k:g}</text>')
        out.append(f'<text x="{left + 150}" y="334" text-anchor="middle">{words[0]}</text>')
        out.append(f'<text x="{left - 34}" y="160" text-anchor="middle" transform="rotate(-90 {left - 34} 160)">{words[1]}</text>')

    def x(self, t):
        return self.left + 300 * t / self.across

    def y(self, k):
        return 300 - 280 * k / self.up

    def line(self, points, colour, style=""):
        self.out.append(f'<path d="M{" ".join(f"{self.x(t):.1f} {self.y(k):.1f}" for t, k in points)}" fill="none" '
                        f'stroke="{colour}" stroke-width="1.3" {style}/>')

    def dots(self, points, colour):
        for t, k in points:
            self.out.append(f'<circle cx="{self.x(t):.1f}" cy="{self.y(k):.1f}" r="3" fill="{colour}"/>')

    def words(self, t, k, text, colour):
        self.out.append(f'<text x="{self.x(t):.0f}" y="{self.y(k):.0f}" fill="{colour}">{text}</text>')


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 740 340" font-family="sans-serif" font-size="12">',
           '<rect width="740" height="340" fill="white"/>']
    blue, green, violet = "#31688e", "#35b779", "#440154"
    plate = Panel(out, 50, 10.5, 3.0, ("time, microseconds", "K over s sqrt(pi a)"), (range(0, 11, 2), range(0, 4)))
    plate.line(history(sys.argv[1], 1e-3, 100 * math.sqrt(2.4 * math.pi)), blue)
    plate.dots(CHEN + [(6.82, 2.668)], blue)
    body = Panel(out, 420, 6.6, 1.5, ("c_d t/a", "K over its value at rest"), (range(0, 7), (0, 0.5, 1, 1.5)))
    early = [(t / 50, intensity(0.25, 1.0, t / 50)) for t in range(1, 101)]
    body.line([(t, k / math.sqrt(math.pi)) for t, k in early], "#444", 'stroke-dasharray="4 3"')
    body.line([(t, k * math.sqrt(math.pi) / 2) for t, k in early[:75]], "#444", 'stroke-dasharray="4 3"')
    body.line(history(sys.argv[2], 1.0, math.sqrt(math.pi)), green)
    body.dots([(3.9, 1.30)], green)
    body.line(history(sys.argv[3], 1.0, 2 / math.sqrt(math.pi)), violet)
    body.dots(PENNY, violet)
    body.words(3.0, 0.9, "crack", green)
    body.words(1.0, 1.2, "penny", violet)
    Path(sys.argv[4]).write_text("\n".join(out + ["</svg>", ""]))


if __name__ == "__main__":
    main()

"""Stress intensity of crack_step from the opening near the tip: crack_intensity.py RUN DECK NEAR FAR

The opening at the distance r from the tip (x = 0) is 8 (1 - nu^2) K/E sqrt(r/(2 pi)) (1 + O(r)): K of every node of the
face with NEAR <= r <= FAR, a line through them, its value at the tip. The deck is the upper half of the plate: what opens
is twice the displacement. Writes intensity.csv: time, arrivals (time over that of the wave), K, ratio (over Freund's).
"""
import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "verification/make"))
from crack import intensity  # noqa: E402
from spacetime_basics import speed_d  # noqa: E402
from spacetime_cracks import PLATE_HEIGHT, STEEL, STEP_STRESS  # noqa: E402


def at_tip(points):
    """The value at r = 0 of the line through (r, K)."""
    mean_r, mean_k = (sum(p[i] for p in points) / len(points) for i in (0, 1))
    slope = sum((r - mean_r) * k for r, k in points) / sum((r - mean_r) ** 2 for r, _ in points)
    return mean_k - slope * mean_r


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    run, near, far = Path(sys.argv[1]), float(sys.argv[3]), float(sys.argv[4])
    factor = STEEL["young"] / (8 * (1 - STEEL["poisson"] ** 2)) * math.sqrt(2 * math.pi)
    speed, times, places = speed_d(**STEEL), {}, {}
    with (run / "nodout.csv").open(newline="") as stream:
        for row in csv.DictReader(stream, skipinitialspace=True):
            # Where it was at first: near the tip the motion along the face would change K by a per cent.
            r = places.setdefault(row["id"], -float(row["x_coordinate"]))
            if near <= r <= far:
                times.setdefault(float(row["time"]), []).append((r, 2 * factor * float(row["y_displacement"]) / math.sqrt(r)))
    count = sum(near <= r <= far for r in places.values())
    if count < 3:
        sys.exit(f"only {count} nodes of the face between {near:g} and {far:g} from the tip are in the history")
    with (run / "intensity.csv").open("w") as stream:
        stream.write("time,arrivals,K,ratio\n")
        for time, points in times.items():
            reach = speed * time - PLATE_HEIGHT
            if reach > 0:
                k = at_tip(points)
                stream.write(f"{time:.10g},{time * speed / PLATE_HEIGHT:.6g},{k:.6g},"
                             f"{k / intensity(STEEL['poisson'], STEP_STRESS, reach):.6g}\n")


if __name__ == "__main__":
    main()

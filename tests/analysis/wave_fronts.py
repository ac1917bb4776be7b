"""Speeds of the waves of wave_scattering: wave_fronts.py RUN DECK

Each wave is looked for where the exact solution of a semi-infinite crack has it, in histories of velocity: the time by
which the exact history must be shifted to match best, over its arrival, is how late the wave is. One speed is fitted to
all places of a wave.

  incident  the line through the opening in the middle of the crack, back to zero
  P, S      the circles that leave a tip, at nodes ahead of it (S: within its front, P and S together)
  Rayleigh  the pulse that runs along the faces from the tip

Writes fronts.csv: time, front, speed. Lengths in crack lengths, times in crossings of one by a P wave; stress 2 arrives.
"""
import csv
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "verification/make"))
from crack import StepLoadedCrack, rayleigh  # noqa: E402

NU, TIP, ARRIVAL, STRESS, STEP, MEAN = 0.3, 0.5, 1.0, 2.0, 0.005, 0.04
EXACT = StepLoadedCrack(NU)
SHEAR = 1.0 / EXACT.b
SURFACE = SHEAR * rayleigh(NU)


def histories(run):
    nodes = {}
    with (run / "nodout.csv").open(newline="") as stream:
        for row in csv.DictReader(stream, skipinitialspace=True):
            value = lambda name: float(row[name])
            nodes.setdefault(row["id"], []).append(
                (value("time") - ARRIVAL, value("x_velocity"), value("y_velocity"), value("x_coordinate"), value("y_coordinate")))
    return nodes


def table(velocity, end):
    """Linear interpolation of an exact history, (v_x, v_y) by time, zero before its start."""
    values = [velocity(STEP * k) for k in range(1, round(end / STEP) + 2)]

    def at(t):
        k = t / STEP - 1
        if k <= 0:
            return 0.0, 0.0
        i = min(int(k), len(values) - 2)
        return tuple(p + (k - i) * (q - p) for p, q in zip(values[i], values[i + 1]))
    return at


def speed(places):
    """One speed for a wave: places are (time of arrival, rows (t, v_x, v_y), exact, components)."""
    def misfit(late):
        return sum((row[1 + c] - exact(row[0] - late * arrival)[c]) ** 2
                   for arrival, rows, exact, components in places for row in rows for c in components)
    low, high = -0.1, 0.1
    best = min((low + (high - low) * k / 40 for k in range(41)), key=misfit)
    low, high = best - 0.005, best + 0.005
    for _ in range(40):    # the misfit has one minimum there
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (low, b) if misfit(a) < misfit(b) else (a, high)
    return 1.0 / (1.0 + (low + high) / 2)


def incident(run):
    """Arrival at the crack: opening, a line in time, in its middle."""
    with (run / "crack.csv").open(newline="") as stream:
        rows = [(float(r["time"]), float(r["opening"]), r["id"]) for r in csv.DictReader(stream, skipinitialspace=True)]
    middle = rows[0][2]    # the deck lists it first
    points = [(t, u) for t, u, node in rows if node == middle and ARRIVAL + 0.1 < t < ARRIVAL + 0.4]
    mean_t, mean_u = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    slope = sum((t - mean_t) * u for t, u in points) / sum((t - mean_t) ** 2 for t, _ in points)
    return ARRIVAL / (mean_t - mean_u / slope)


def measure(run):
    circles, shear, faces = [], [], []
    for rows in histories(run).values():
        x, y = rows[0][3] - TIP, rows[0][4]
        r = math.hypot(x, y)
        window = lambda low, high: [row for row in rows if low < row[0] < min(high, 0.93)]
        if x > 0.0 and y > 0.0:
            exact = table(lambda t: tuple(STRESS * v for v in EXACT.velocity_ahead(x, y, t, 30)), 1.0)
            circles.append((r, window(0.7 * r, 1.5 * r), exact, (0,)))
            shear.append((r / SHEAR, window(1.55 * r, 2.4 * r), exact, (0, 1)))
        elif abs(y) < 1e-9 and -0.5 < x < -0.2:
            near, far, side = -x, 1.0 + x, math.copysign(1.0, rows[-1][2])
            face = lambda t: side * STRESS * t * (1 + sum(EXACT.displacement(t / q) - 1 for q in (near, far)))
            # The exact velocity has a logarithm at the Rayleigh wave: means over what elements resolve.
            exact = table(lambda t: (0.0, (face(t + MEAN) - face(max(t - MEAN, 0.0))) / (MEAN + min(t, MEAN))), 1.1)
            faces.append((near / SURFACE, window(0.75 * near / SURFACE, 1.25 * near / SURFACE), exact, (1,)))
    return {"incident": incident(run), "P": speed(circles), "S": SHEAR * speed(shear), "Rayleigh": SURFACE * speed(faces)}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    run = Path(sys.argv[1])
    with (run / "fronts.csv").open("w") as stream:
        stream.write("time,front,speed\n")
        for name, value in measure(run).items():
            stream.write(f"0,{name},{value:.6g}\n")
            print(f"    {name:9s} {value:.6g}")


if __name__ == "__main__":
    main()

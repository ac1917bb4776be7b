"""Hoop stress at the wall of a round cavity about the origin, in the plane: hoop_at_wall.py RUN DECK RADIUS REACH

At the wall itself the corners of its straight edges disturb the stress, by 4 % where they are a twentieth of the radius long;
in the middle of the elements along it by less than 1 %. A parabola is laid through the hoop stress in the middle of all
triangles up to REACH from the wall; its value there is the result. Writes hoop_at_wall.csv: time, hoop.
"""
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from field_picture import read_vtu  # noqa: E402


def middles(points, arrays):
    """The number of the point in the middle of each triangle: each has its own points, one after the other."""
    block = len(points) // 3 // len(set(arrays["CellData", "element_id"][1]))
    for first in range(0, len(points) // 3, block):
        mine = [points[3 * p:3 * p + 2] for p in range(first, first + block)]
        centre = [sum(x[k] for x in mine) / block for k in (0, 1)]      # the points lie evenly
        nearest = min(range(block), key=lambda p: math.dist(mine[p], centre))
        if math.dist(mine[nearest], centre) > 1e-4 * math.dist(mine[0], centre):
            sys.exit("no point in the middle of a triangle: NSUB of *CONTROL_SPACETIME must be a multiple of 3")
        yield first + nearest


def constant(rows):
    """Of the parabola through (x, value), by least squares."""
    m = [[sum(x ** (i + j) for x, _ in rows) for j in range(3)] + [sum(v * x ** i for x, v in rows)] for i in range(3)]
    for i in range(3):
        for k in set(range(3)) - {i}:
            m[k] = [a - m[k][i] / m[i][i] * b for a, b in zip(m[k], m[i])]
    return m[0][3] / m[0][0]


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    run, radius, reach = Path(sys.argv[1]), float(sys.argv[3]), float(sys.argv[4])
    frames = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', (run / "result.pvd").read_text())
    lines, near = ["time,hoop"], None
    for time, name in frames:
        points, arrays = read_vtu(run / name)
        stress = arrays["PointData", "stress"][1]      # xx yy xy
        near = near or [p for p in middles(points, arrays) if math.hypot(*points[3 * p:3 * p + 2]) < radius + reach]
        rows = []
        for p in near:
            x, y = points[3 * p:3 * p + 2]
            r = math.hypot(x, y)
            xx, yy, xy = stress[3 * p:3 * p + 3]
            rows.append((r / radius - 1, (y * y * xx + x * x * yy - 2 * x * y * xy) / (r * r)))
        lines.append(f"{time},{constant(rows):.7g}")
    (run / "hoop_at_wall.csv").write_text("\n".join(lines + [""]))


if __name__ == "__main__":
    main()

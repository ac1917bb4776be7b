"""Values of a field of the pictures at places: field_at.py RUN DECK FIELD X,Y[,Z]...

Takes the point of the subdivided cells that is nearest to each place, in every frame of the run. Writes field_at.csv:
time, place (1, 2, ... as given), FIELD; components of a field with several as FIELD_0, FIELD_1, ...
"""
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from field_picture import read_vtu  # noqa: E402


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    run, field = Path(sys.argv[1]), sys.argv[3]
    places = [tuple(float(v) for v in (words + ",0").split(",")[:3]) for words in sys.argv[4:]]
    frames = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', (run / "result.pvd").read_text())
    rows, near = [], None
    for time, name in frames:
        points, arrays = read_vtu(run / name)
        size, values = arrays["PointData", field]
        near = near or [min(range(len(points) // 3), key=lambda p: math.dist(points[3 * p:3 * p + 3], place)) for place in places]
        rows += [f"{time},{k + 1}," + ",".join(f"{v:.7g}" for v in values[size * p:size * (p + 1)]) for k, p in enumerate(near)]
    names = [field] if size == 1 else [f"{field}_{c}" for c in range(size)]
    (run / "field_at.csv").write_text("\n".join([",".join(["time", "place", *names]), *rows, ""]))


if __name__ == "__main__":
    main()

"""Is the opening of a round crack the same all the way round? axisymmetry.py RUN DECK

Groups the nodes of the history by their distance from the z axis. Writes axisymmetry.csv: time, radius, places (nodes of
that radius), mean (z displacement), spread (largest less smallest, over the largest magnitude).
"""
import csv
import math
import sys
from pathlib import Path


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    run, where, groups = Path(sys.argv[1]), {}, {}
    with (run / "nodout.csv").open(newline="") as stream:
        for row in csv.DictReader(stream, skipinitialspace=True):
            place = tuple(float(row[k + "_coordinate"]) for k in "xyz")
            radius = round(math.hypot(*where.setdefault(row["id"], place)[:2]), 6)   # where it was at first
            groups.setdefault((float(row["time"]), radius), []).append(float(row["z_displacement"]))
    with (run / "axisymmetry.csv").open("w") as stream:
        stream.write("time,radius,places,mean,spread\n")
        for (time, radius), values in sorted(groups.items()):
            if time > 0 and radius > 0:
                spread = (max(values) - min(values)) / max(map(abs, values))
                stream.write(f"{time:.10g},{radius:g},{len(values)},{sum(values) / len(values):.9g},{spread:.6g}\n")


if __name__ == "__main__":
    main()

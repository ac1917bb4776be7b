"""When a history is largest: peak.py RUN DECK FILE COLUMN ID

Looks at the rows of one entity in FILE.csv. Writes peak.csv: time (of the end), COLUMN (its largest value), at (its time).
"""
import csv
import sys
from pathlib import Path


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    run, name, column, entity = Path(sys.argv[1]), *sys.argv[3:]
    with (run / f"{name}.csv").open(newline="") as stream:
        rows = [(float(r[column]), float(r["time"])) for r in csv.DictReader(stream, skipinitialspace=True) if r["id"] == entity]
    if not rows:
        sys.exit(f"{name}.csv has no rows of {entity}")
    value, at = max(rows)
    (run / "peak.csv").write_text(f"time,{column},at\n{rows[-1][1]:.10g},{value:.10g},{at:.10g}\n")


if __name__ == "__main__":
    main()

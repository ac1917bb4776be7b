#!/usr/bin/env python3
"""The common input: copper Taylor bars of 20k, 50k, 200k and 1M hexahedra, as decks, by the program itself.

usage: taylor.py CLEAVE LIMITS [SIZE...]     (LIMITS: the program bench_limits)

Prints ns per element-cycle of the time loop without output (elements, loads, nodal update), bytes per element, and
the share of the machine's memory bandwidth and multiply-add peak. The machine may be shared: compare ratios of one
call, quote medians of several. One-point hexahedra, hourglass type 2, von Mises with linear hardening.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

# columns of the section: core n x n and m rings, layers, cycles to run
SIZES = {"20k": (8, 5, 90, 600), "50k": (12, 6, 116, 240), "200k": (18, 12, 168, 60), "1M": (32, 20, 279, 16)}
HERE = Path(__file__).resolve().parent
# Read and written per element and cycle at least: the point's record twice (10 numbers and one of history), five
# numbers of the element, connectivity, and the fields of 1.1 nodes.
MOVED = 2 * 8 * 11 + 8 * 5 + 16 + 1.1 * 9 * 8


def run(cleave, deck, folder, threads, cycles):
    out = folder / f"run{threads}"
    subprocess.run([cleave, "run", "-q", "-j", str(threads), "--stop-at-cycle", str(cycles), "-o", out, deck],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((out / "summary.json").read_text())


def main():
    cleave, limits, wanted = sys.argv[1], sys.argv[2], sys.argv[3:] or list(SIZES)
    peak, triad, operations = map(float, subprocess.run([limits], check=True, capture_output=True, text=True).stdout.split())
    print(f"one thread: {peak / 1e9:.0f} GFLOP/s fused multiply-add, {triad / 1e9:.1f} GB/s triad; "
          f"{operations:.0f} operations a visit without the law")
    print(f"{'bar':>6} {'elements':>9} {'threads':>7} {'ns':>7} {'visit':>7} {'bytes':>6} {'of triad':>9} {'of FMA':>7} {'speed-up':>9}")
    for name in wanted:
        n, m, layers, cycles = SIZES[name]
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            deck = folder / "bar.k"
            subprocess.run([sys.executable, HERE / "gen_taylor.py", str(n), str(m), str(layers), "k", deck, "ihq=2"],
                           check=True, stdout=subprocess.DEVNULL)
            single = None
            for threads in (1, 2):
                best = visit = 1e30
                for _ in range(3):
                    summary = run(cleave, deck, folder, threads, cycles)
                    phases, count = summary["speed"]["phases"], summary["speed"]["element_cycles"]
                    best = min(best, 1e9 * sum(v for k, v in phases.items() if k != "output") / count)
                    visit = min(visit, 1e9 * phases["elements"] / count)
                single = single or best
                print(f"{name:>6} {summary['counts']['elements']:9d} {threads:7d} {best:7.1f} {visit:7.1f} "
                      f"{summary['memory']['bytes_per_element']:6.0f} {MOVED / best / threads / (triad / 1e9):9.1%} "
                      f"{operations / visit / threads / (peak / 1e9):7.1%} {single / best:9.2f}", flush=True)


if __name__ == "__main__":
    main()

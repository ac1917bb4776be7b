#!/usr/bin/env bash
# bench.sh [PROGRAM [OPTION...]]: runs the benchmark programs of build/bench, one after the other.
set -euo pipefail
programs=($(compgen -G "build/bench/bench/bench_${1:-*}")) || { echo "bench: no such program" >&2; exit 2; }
for program in "${programs[@]}"; do
  [ -x "$program" ] && [ -f "$program" ] || continue
  echo "== ${program##*/}"
  "$program" "${@:2}"
done

#!/usr/bin/env bash
# bench.sh [PROGRAM [OPTION...]]: runs the benchmark programs of build/bench, one after the other; `taylor` is the
# common input, run as decks by the program itself.
set -euo pipefail
if [ "${1:-taylor}" = taylor ]; then
  echo "== taylor"
  python3 bench/taylor.py build/bench/cleave build/bench/bench/bench_limits "${@:2}"
  [ -z "${1:-}" ] || exit 0
fi
programs=($(compgen -G "build/bench/bench/bench_${1:-*}")) || { echo "bench: no such program" >&2; exit 2; }
for program in "${programs[@]}"; do
  [ -x "$program" ] && [ -f "$program" ] || continue
  echo "== ${program##*/}"
  "$program" "${@:2}"
done

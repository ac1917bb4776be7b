#!/usr/bin/env bash
# tidy.sh BUILD [FILE PATTERN]: clang-tidy with the list of .clang-tidy on every source; says only what is wrong.
# Findings inside the system's headers are not ours; a header's finding is shown once, not per file including it.
set -euo pipefail
command -v run-clang-tidy-14 >/dev/null || { echo 'tidy.sh: no run-clang-tidy-14 (./x setup)' >&2; exit 2; }
# Files come and go: configure anew. Sources that the build writes must be there to be included.
cmake "$1" --log-level=WARNING >/dev/null
ninja -C "$1" --quiet generated
said=$(run-clang-tidy-14 -quiet -p "$1" -j "$(nproc)" "$PWD/src/.*${2:-}" 2>&1) || true
findings=$(sed 's/\x1b\[[0-9;]*[mK]//g' <<<"$said" |
  grep -aE "^($PWD/.*(warning|error): |.*\[clang-diagnostic-error|error: )" | sort -u) || true
[ -z "$findings" ] || { printf '%s\n' "${findings//$PWD\//}"; exit 1; }

#!/usr/bin/env bash
# tidy.sh BUILD [FILE PATTERN]: clang-tidy with the list of .clang-tidy on every source; says only what is wrong.
set -uo pipefail
said=$(run-clang-tidy-14 -quiet -p "$1" -j "$(nproc)" "$PWD/src/.*${2:-}" 2>&1)
status=$?
# One finding in a header is reported by every file that includes it: show it once.
grep -aE '(warning|error): ' <<<"$said" | sed 's/\x1b\[[0-9;]*[mK]//g' | sort -u
exit $status

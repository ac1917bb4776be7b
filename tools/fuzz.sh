#!/usr/bin/env bash
# fuzz.sh [SECONDS] [TARGET]: runs the fuzz programs of build/fuzz, sharing SECONDS (60) among them.
# Seeds: tests/fuzz/corpus/TARGET and the decks of tests/ and examples/. What is found is kept in
# build/fuzz/found/TARGET, a crashing input as build/fuzz/crash-*.
set -euo pipefail
seconds=${1:-60}
programs=($(compgen -G "build/fuzz/fuzz/fuzz_${2:-*}")) || { echo "fuzz: no such target" >&2; exit 2; }
share=$((seconds / ${#programs[@]}))

seeds=build/fuzz/seeds
mkdir -p "$seeds"
find tests examples \( -name '*.k' -o -name '*.key' -o -name '*.dyn' \) -size -64k -not -path '*/fuzz/*' | while read -r deck; do
  cp -u "$deck" "$seeds/$(echo "$deck" | tr / _)"
done

for program in "${programs[@]}"; do
  name=${program##*/fuzz_}
  found=build/fuzz/found/$name
  mkdir -p "$found"
  corpus=tests/fuzz/corpus/$name
  echo "== fuzz_$name for $share s"
  "$program" -max_total_time="$share" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix=build/fuzz/ "$found" $([ -d "$corpus" ] && echo "$corpus") "$seeds" 2>&1 |
    grep -vE '^#[0-9]+\s+(NEW|REDUCE|pulse|RELOAD)' 
done

#!/usr/bin/env bash
# Instructions of the draws at each map size, by callgrind, where the processor's own counters
# cannot be read. Each size runs the same few draws, so the totals are to be compared with each other.
# usage: share/scripts/count-instructions.sh [ROW], after ./dev bench has built the program
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
bench=${RTOB_BENCH:-build/bin/rtob-bench}
row=${1:-draw/revisit}
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for size in 10000 100000 1000000 10000000 100000000; do
    # Counted is what the draw does, not the making of the map.
    valgrind --tool=callgrind --callgrind-out-file="$out" --collect-atstart=no \
        --toggle-collect='rtob::ReferenceDraw::draw*' "$bench" \
        --benchmark_filter="^$row/$size\$" --benchmark_min_time=0.001 >/dev/null 2>&1
    printf '%s/%s: %s instructions\n' "$row" "$size" "$(sed -n 's/^totals: //p' "$out")"
done

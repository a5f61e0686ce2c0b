#!/usr/bin/env bash
# Instructions of one draw (and one draw and match) at each map size, where the processor's own
# counters cannot be read: callgrind counts an odd and an even number of rounds.
# usage: share/scripts/count-instructions.sh [FILTER], after ./dev bench has built the program
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
bench=${RTOB_BENCH:-build/bin/rtob-bench}
filter=${1:-draw/revisit}
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for size in 10000 100000 1000000 10000000 100000000; do
    # Only what the drawing function does is counted, not the map's making.
    calls=$(valgrind --tool=callgrind --callgrind-out-file="$out" --collect-atstart=no \
        --toggle-collect='rtob::ReferenceDraw::draw*' "$bench" \
        --benchmark_filter="^$filter/$size\$" --benchmark_min_time=0.01 \
        --benchmark_format=csv 2>/dev/null | tail -1 | cut -d, -f2)
    total=$(sed -n 's/^totals: //p' "$out")
    printf '%s/%s: %s instructions in a draw (%s timed)\n' "$filter" "$size" "$total" "$calls"
done

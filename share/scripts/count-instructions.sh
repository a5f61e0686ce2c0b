#!/usr/bin/env bash
# Instructions of a benchmark's row at each map size, by callgrind, where the processor's own counters
# cannot be read: of the draws, or of Slam::process where ROW begins with "process". Printed are those
# of one call, the mean over all calls of the run.
# usage: share/scripts/count-instructions.sh [ROW], after ./dev bench has built the program
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
bench=${RTOB_BENCH:-build/bin/rtob-bench}
row=${1:-draw/revisit}
function='rtob::ReferenceDraw::draw('
[[ $row == process* ]] && function='rtob::Slam::process('
out=$(mktemp)
trap 'rm -f "$out"' EXIT

# How often the function was called: callgrind writes a name once, then its number.
calls() {
    awk -v wanted="$function" '
        /^c?fn=\(/ {
            number = $0; sub(/^c?fn=/, "", number); sub(/\).*/, ")", number)
            if (index($0, ") ") > 0) name[number] = substr($0, index($0, ") ") + 2)
            callee = /^cfn=/ ? name[number] : ""
        }
        /^calls=/ && index(callee, wanted) == 1 { split($1, part, "="); sum += part[2] }
        END { print sum }' "$out"
}

for size in 10000 100000 1000000 10000000 100000000; do
    # Counted is what the function does, not the making of the map.
    valgrind --tool=callgrind --callgrind-out-file="$out" --collect-atstart=no \
        --toggle-collect="$function*" "$bench" \
        --benchmark_filter="^$row/$size\$" --benchmark_min_time=0.2 >/dev/null 2>&1
    total=$(sed -n 's/^totals: //p' "$out")
    printf '%s/%s: %s instructions a call, %s calls\n' \
        "$row" "$size" $((total / $(calls))) "$(calls)"
done

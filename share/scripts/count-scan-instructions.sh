#!/usr/bin/env bash
# Instructions of each scan of a run, Slam::process(), by callgrind: their median and largest number,
# of scans that are only tracked, of those that are written, and of those that are searched for.
# usage: share/scripts/count-scan-instructions.sh LOG [options of rtob-slam run]; some 50 times slower
# than the run itself
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
program=${RTOB_PROGRAM:-build/bin/rtob-slam}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
process='rtob::Slam::process(mrpt::obs::CObservation2DRangeScan const&)'

valgrind --tool=callgrind --callgrind-out-file="$out/part" --collect-atstart=no \
    --toggle-collect="$process" --dump-after="$process" \
    "$program" run "$@" -o "$out/run" --quiet >"$out/log" 2>&1 || {
    cat "$out/log" >&2
    exit 1
}
# part.1, part.2 ... are the scans in their order, as poses.csv has them; its columns 18 and 20 say
# whether the scan was written and searched for.
for ((scan = 1; ; scan++)); do
    [[ -f $out/part.$scan ]] || break
    sed -n 's/^totals: //p' "$out/part.$scan"
done | paste -d, - <(tail -n +2 "$out/run/poses.csv") |
    awk -F, '{ print ($21 == 1 ? "searched" : $19 == 1 ? "written" : "tracked"), $1 }' |
    sort -k1,1 -k2,2n |
    awk '{ count[$1]++; value[$1, count[$1]] = $2 }
        END { for (kind in count) {
                  n = count[kind]
                  printf "%s: %d scans, median %.2f million, most %.2f million\n",
                      kind, n, value[kind, int((n + 1) / 2)] / 1e6, value[kind, n] / 1e6
              } }' | sort

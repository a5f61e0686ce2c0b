#!/usr/bin/env bash
# Accuracy and cost on the real logs: every log with several seeds and one configuration, the
# default. Writes one CSV row a run and the table of docs/evaluation.md.
# usage: share/scripts/evaluate.sh [SEEDS, default 10] [LOG-NAME...], with RTOB_DATASETS set
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
program=${RTOB_PROGRAM:-build/bin/rtob-slam}
seeds=${1:-10}
[[ $# -gt 0 ]] && shift
if [[ ! -d ${RTOB_DATASETS:-} ]]; then
    echo "evaluate: set RTOB_DATASETS to the folder with the real logs (see datasets/README.md)" >&2
    exit 1
fi

# name, log, relations, further flags
logs="intel intel/intel.clf.bz2 intel/intel.relations.gz
fr079 fr079/fr079.clf.bz2 fr079/fr079.relations.gz
killian mit-killian/mit-killian.reconstructed.clf.gz mit-killian/mit-killian.relations.gz
intel-no-odometry intel/intel.clf.bz2 intel/intel.relations.gz --no-odometry
fr079-no-odometry fr079/fr079.clf.bz2 fr079/fr079.relations.gz --no-odometry"

out=out/evaluate
mkdir -p "$out"
export program out RTOB_DATASETS

run_one() { # name log relations seed flags...
    local name=$1 log=$2 relations=$3 seed=$4
    shift 4
    local folder="$out/$name-$seed"
    "$program" run "$RTOB_DATASETS/$log" -o "$folder" --overwrite --seed "$seed" --quiet "$@" \
        >"$folder.txt" 2>&1 </dev/null || echo "$name seed $seed: exit $?" >&2
    "$program" eval "$folder/trajectory.tum" "$RTOB_DATASETS/$relations" --json >"$folder.json"
    # Only the summary and the errors stay: a run's map is tens of megabytes.
    rm -f "$folder"/map.* "$folder"/timing.csv "$folder"/poses.csv
}
export -f run_one

jobs=()
while read -r name log relations flags; do
    if [[ $# -gt 0 && " $* " != *" $name "* ]]; then continue; fi
    for seed in $(seq "$seeds"); do
        jobs+=("run_one $name $log $relations $seed $flags")
    done
done <<<"$logs"
printf '%s\n' "${jobs[@]}" | xargs -P "$(nproc)" -I{} bash -c '{}'

python3 share/scripts/evaluate_table.py "$out"

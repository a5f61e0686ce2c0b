#!/usr/bin/env bash
# Feeds the parsers of what comes over a line with damaged bytes, by clang's libFuzzer: ten million
# times each, or as often as said. Usage: ./dev fuzz [RUNS] [rplidar|mavlink ...]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
runs=${1:-10000000}
[[ $# -eq 0 ]] || shift
parsers=("$@")
[[ ${#parsers[@]} -gt 0 ]] || parsers=(rplidar mavlink)

share/scripts/install-packages.sh fuzz
drivers=libs/rtob-drivers
declare -A sources=(
    [rplidar]="beam_grid capsule_reader revolution_builder rplidar_packets rplidar_parser rplidar_protocol steady_stamps"
    [mavlink]="mavlink_frame"
)
mkdir -p build/fuzz
for parser in "${parsers[@]}"; do
    files=()
    for name in ${sources[$parser]}; do files+=("$drivers/src/$name.cpp"); done
    echo "== Build the fuzzer of $parser"
    clang++-14 -std=c++17 -O2 -g -fsanitize=fuzzer,address,undefined \
        -fno-sanitize-recover=all -I "$drivers/include" "tests/fuzz/fuzz_$parser.cpp" \
        "${files[@]}" -o "build/fuzz/$parser"
    mkdir -p "build/fuzz/corpus-$parser"
    echo "== $runs runs of $parser"
    build/fuzz/"$parser" -runs="$runs" -max_len=1024 -print_final_stats=1 -verbosity=0 \
        -artifact_prefix="build/fuzz/$parser-" "build/fuzz/corpus-$parser" "tests/fuzz/seeds-$parser"
done

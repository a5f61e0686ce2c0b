#!/usr/bin/env bash
# Installs what is missing of the given groups of share/packages.txt. Quick when nothing is missing.
# Usage: install-packages.sh build test ...
set -euo pipefail
list="$(dirname "$(readlink -f "$0")")/../packages.txt"

packages_of_groups() {
    local group
    for group in "$@"; do
        awk -v group="$group" '$1 == group { print $2 }' "$list"
    done | sort -u
}

installed_packages() {
    # dpkg-query fails when it knows nothing of some of the names.
    { dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true; } |
        awk '$1 == "installed" { print $2 }' | sort -u
}

mapfile -t wanted < <(packages_of_groups "$@")
if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: going on without installing. Needed are: ${wanted[*]}"
    exit 0
fi
mapfile -t missing < <(comm -23 <(printf '%s\n' "${wanted[@]}") <(installed_packages "${wanted[@]}"))
if [[ ${#missing[@]} -eq 0 ]]; then
    echo "Packages: all there ($*)."
    exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        echo "Run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
echo "Packages: installing ${missing[*]}"
"${apt[@]}" update
"${apt[@]}" install -y --no-install-recommends "${missing[@]}"

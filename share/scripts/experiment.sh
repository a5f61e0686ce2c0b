#!/usr/bin/env bash
# The paper's experiments and more, in simulation: docs/experiments.md.
# usage: share/scripts/experiment.sh NAME... [--seeds N] [--compare]; --help lists the names
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
share/scripts/install-packages.sh evaluate >/dev/null
[[ -x ${RTOB_PROGRAM:-build/bin/rtob-slam} ]] || ./dev build
exec python3 share/scripts/experiment.py "$@"

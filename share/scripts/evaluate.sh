#!/usr/bin/env bash
# Accuracy and cost on the real logs, and the tables and pictures of docs/evaluation.md.
# usage: share/scripts/evaluate.sh [LOG...] [--seeds N] ...; --help lists the logs
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
share/scripts/install-packages.sh evaluate >/dev/null
[[ -n ${RTOB_PROGRAM:-} ]] || ./dev build >/dev/null
exec /usr/bin/python3 share/scripts/evaluate.py "$@"

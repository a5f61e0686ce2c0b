#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Every test that docs/paper-map.md names must exist. Usage: check_paper_map.sh SOURCE_FOLDER
set -eu
cd "$1"
names=$(grep -o '`[A-Z][A-Za-z0-9]*\.[A-Z][A-Za-z0-9]*`' docs/paper-map.md | tr -d '`' | sort -u)
test -n "$names"
missing=0
for name in $names; do
    if ! grep -rqE "^TEST(_[FP])?\(${name%.*}, ${name#*.}\)" tests --include='test_*.cpp'; then
        echo "docs/paper-map.md names a test that is not there: $name" >&2
        missing=1
    fi
done
exit $missing

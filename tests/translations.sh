#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# translations.sh LUPDATE: every text in the sources has a translation in every file of translations/.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
for file in translations/*.ts; do
    cp "$file" "$work/collected.ts"
    translations/collect.sh "$1" "$work/collected.ts"
    missing=$(grep -B 1 'type="unfinished"' "$work/collected.ts" | sed -n 's/.*<source>\(.*\)<\/source>.*/\1/p')
    if [ -n "$missing" ]; then
        echo "$file lacks, or has not checked (build the target \`translations\`, then translate):"
        echo "$missing"
        status=1
    fi
done
exit $status

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All experiments, quick, from nothing to the report; then from what was kept, in German and once more:
# lab_all_test.sh PROGRAM.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $1"; exit 1; }

"$program" lab all --quick --out out
names=$(ls out/cache | sed 's/\.csv$//')
[[ $(wc -w <<< "$names") -ge 7 ]] || fail "experiments: $names"
for name in $names; do
  ls "out/$name"/*.csv "out/$name"/*.svg > /dev/null || fail "$name left no tables or no charts"
  grep -q "id=\"$name\"" out/report.html || fail "$name is not in the report"
done
! grep -qE 'class="answer">[^<]*\b(nan|inf)\b' out/report.html || fail "an answer without its number"

cp -r out before
"$program" lab all --quick --out out --lang de > german.txt
english='the|of|and|is|are|with|time|spheres|step|by|times'
names='s/`[^`]*`//g; s/](.*)//; s/[Ss]ort[- ]and[- ][Ss]weep//g'
! sed "$names" out/report.md german.txt | grep -nwE "$english" ||
  fail "English words in the German report"
! grep -hoE '<text[^>]*>(<tspan[^>]*>)?[^<]*' out/*/*.svg | sed "s/.*>//; $names" | grep -wE "$english" ||
  fail "English words in the German charts"
! grep '^| ' out/report.md | grep -E '[0-9]\.[0-9]' || fail "decimal points in the German report"
"$program" lab all --quick --out out > /dev/null
diff -r before out || fail "the third time is not the same as the first"

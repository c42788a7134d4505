#!/usr/bin/env bash
# A small study from end to end: study_test.sh PENUMBRA_STUDY. Where a browser is found, the page is used in it.
set -uo pipefail
study=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
fail() { echo "FAIL: $*"; failures=$((failures + 1)); }

study() {
    local out=$1
    shift
    "$study" 05-shadow-map 06-pcss --scene halfplane --quick --out "$scratch/$out" "$@" >"$scratch/$out.txt" 2>&1 ||
        fail "$out ended with $?: $(tail -n 3 "$scratch/$out.txt")"
}
study whole
for file in study.json study.csv study.svg study.html; do
    [ -s "$scratch/whole/$file" ] || fail "$file is missing"
done
[ -e "$scratch/whole.measured" ] && fail "answers are left behind"

# Killed after its second answer, then resumed: what was measured is not measured again.
"$study" 05-shadow-map 06-pcss --scene halfplane --quick --out "$scratch/killed" >/dev/null 2>&1 &
answers() { ls "$scratch/killed.measured"/*.frame 2>/dev/null; }
while kill -0 $! 2>/dev/null && [ "$(answers | wc -l)" -lt 2 ]; do sleep 0.05; done
{ kill -9 $! && wait $!; } 2>/dev/null
mkdir "$scratch/kept"
answers | while read -r answer; do ln "$answer" "$scratch/kept/"; done  # a link stays when the study tidies up
count=$(ls "$scratch/kept" | wc -l)
case $count in 2 | 3) ;; *) fail "the kill left $count of 4 answers: not mid-way" ;; esac
[ -e "$scratch/killed" ] && fail "a killed study leaves an output"
study killed --resume
# The shortest or longest of the repetitions stands in the result to the last digit, unless measured anew.
for answer in "$scratch"/kept/*; do
    grep -a -o '"wall\.0\.[0-9]*":[0-9.e-]*' "$answer" | cut -d: -f2 | grep -q -F -f - "$scratch/killed/study.json" ||
        fail "$(basename "$answer") was measured again"
done

for run in whole killed; do  # commas within quotes part no fields
    errors=$(sed 's/"[^"]\+"/Q/g' "$scratch/$run/study.csv" |
        awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "error") column = i } NR > 1 && $column != ""' | wc -l)
    [ "$(wc -l <"$scratch/$run/study.csv")" -gt 10 ] || fail "$run has hardly a point"
    [ "$errors" = 0 ] || fail "$run: $errors points have an error: $(grep -m 1 '"error"' "$scratch/$run/study.json")"
done
# In study.json, every digit counts.
errors() { grep -E '"(scene|program|settings|rmse|mean_absolute|percentile_99|penumbra_rmse|false_shadow_rate|light_leak_rate)":' "$1/study.json"; }
cmp -s <(errors "$scratch/whole") <(errors "$scratch/killed") ||
    fail "errors differ between a whole study and a resumed one: $(diff <(errors "$scratch/whole") <(errors "$scratch/killed") | head -n 4)"
grep -q '"rays"' "$scratch/whole/study.csv" || fail "no competitor was measured"
grep -q '"closed form"' "$scratch/whole/study.csv" || fail "halfplane was not compared with its formula"

refuse() {
    local what=$1
    shift
    "$study" --out "$scratch/bad" "$@" >"$scratch/stdout" 2>"$scratch/stderr"
    local code=$?
    [ $code = 2 ] || fail "$what: exit $code instead of 2"
    [ "$(wc -l <"$scratch/stderr")" = 1 ] || fail "$what: not one line: $(cat "$scratch/stderr")"
    [ -e "$scratch/bad" ] && fail "$what: leaves something under --out"
    return 0
}
refuse "unknown assignment" nowhere
refuse "unknown scene" 05-shadow-map --scene nowhere
refuse "submission to nothing" --submission "$scratch"

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
if [ -n "$browser" ] && [ -s "$scratch/whole/study.html" ]; then
    title=$(HOME=$scratch timeout 100 "$browser" --headless --no-sandbox --disable-gpu --virtual-time-budget=60000 --dump-dom \
        "file://$scratch/whole/study.html#selftest" 2>/dev/null | grep -o '<title>[^<]*')
    case $title in *"selftest passed"*) echo "$title" ;; *) fail "the page in a browser: $title" ;; esac
else
    echo "no browser: the page was not opened"
fi
[ $failures = 0 ] && echo "study: all good"
exit $((failures > 0))

#!/usr/bin/env bash
# A small study from end to end: study_test.sh PENUMBRA_STUDY. Where a browser is found, the page is used in it.
set -uo pipefail
study=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
fail() { echo "FAIL: $*"; failures=$((failures + 1)); }

for run in a b; do
    "$study" 05-shadow-map 06-pcss --scene halfplane --quick --out "$scratch/$run" >"$scratch/$run.txt" 2>&1 ||
        fail "study ended with $?: $(tail -n 3 "$scratch/$run.txt")"
done
for file in study.json study.csv study.svg study.html; do
    [ -s "$scratch/a/$file" ] || fail "$file is missing"
done
[ -e "$scratch/a.measured" ] && fail "answers are left behind"
grep -q ',rays,' "$scratch/a/study.csv" || grep -q '"rays"' "$scratch/a/study.csv" || fail "no competitor was measured"
grep -q '"closed form"' "$scratch/a/study.csv" || fail "halfplane was not compared with its formula"
# Columns before the times: every error must come out the same, bit for bit.
errors() { cut -d, -f1-3 "$1"; grep -o '"rmse": [0-9.e-]*' "${1%csv}json"; }
cmp -s <(errors "$scratch/a/study.csv") <(errors "$scratch/b/study.csv") || fail "errors differ between two runs"

# Interrupted, then resumed: what was measured is not measured again.
timeout -s KILL 6 "$study" 05-shadow-map --scene halfplane --quick --out "$scratch/c" >/dev/null 2>&1
kept=$(ls "$scratch/c.measured" 2>/dev/null | wc -l)
"$study" 05-shadow-map --scene halfplane --quick --resume --out "$scratch/c" >"$scratch/c.txt" 2>&1 || fail "resume ended with $?"
[ -s "$scratch/c/study.html" ] || fail "nothing after --resume ($kept answers were kept)"

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
if [ -n "$browser" ] && [ -s "$scratch/a/study.html" ]; then
    title=$(HOME=$scratch timeout 100 "$browser" --headless --no-sandbox --disable-gpu --virtual-time-budget=60000 --dump-dom \
        "file://$scratch/a/study.html#selftest" 2>/dev/null | grep -o '<title>[^<]*')
    case $title in *"selftest passed"*) echo "$title" ;; *) fail "the page in a browser: $title" ;; esac
else
    echo "no browser: the page was not opened"
fi
[ $failures = 0 ] && echo "study: all good"
exit $((failures > 0))

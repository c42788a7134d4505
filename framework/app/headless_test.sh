#!/usr/bin/env bash
# Headless frames as a person asks for them: headless_test.sh PROGRAM. No DISPLAY, no GPU.
set -uo pipefail
program=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset DISPLAY
failures=0
fail() { echo "FAIL: $*"; failures=$((failures + 1)); }

# Two runs give the same bits in every image.
for run in a b; do
    "$program" render --scene stairs --size 256x192 --out "$scratch/$run" || fail "render ended with $?"
done
for image in visibility color depth; do
    [ -s "$scratch/a/$image.png" ] || fail "$image.png is missing"
done
for file in "$scratch"/a/*.exr; do
    cmp -s "$file" "$scratch/b/$(basename "$file")" || fail "$(basename "$file") differs between two runs"
done
grep -q '"milliseconds"' "$scratch/a/frame.json" || fail "frame.json names no times"

# Bad input: one line on stderr, exit 2, nothing under --out.
refuse() {
    local what=$1
    shift
    "$program" render --out "$scratch/bad" "$@" >"$scratch/stdout" 2>"$scratch/stderr"
    local code=$?
    [ $code = 2 ] || fail "$what: exit $code instead of 2"
    [ "$(wc -l <"$scratch/stderr")" = 1 ] || fail "$what: not one line: $(cat "$scratch/stderr")"
    [ -s "$scratch/stdout" ] && fail "$what: speaks on stdout"
    [ -e "$scratch/bad" ] && fail "$what: leaves something under --out"
    return 0
}
echo "not a model" >"$scratch/broken.glb"
refuse "unknown scene" --scene nowhere
refuse "missing file" --scene "$scratch/missing.glb"
refuse "broken file" --scene "$scratch/broken.glb"
refuse "bad size" --scene boxes --size 0x5
refuse "huge size" --scene boxes --size 90000x5
refuse "no number" --scene boxes --size 12by9
refuse "unknown setting" --scene boxes --set nosuch=1
refuse "setting without value" --scene boxes --set nosuch
refuse "unknown image" --scene boxes --size 32x32 --image nosuch
refuse "missing layer" --scene boxes --layer "$scratch/nowhere"
refuse "unknown flag" --scene boxes --nosuch

# A shader that does not compile is named by the student's own file and line.
mkdir "$scratch/layer"
cp "$(dirname "$0")/../shaders/shading.glsl" "$scratch/layer/"
sed -i '1s/^/float broken( { return 1.0; }\n/' "$scratch/layer/shading.glsl"
"$program" render --scene boxes --size 32x32 --layer "$scratch/layer" --out "$scratch/bad" 2>"$scratch/stderr"
[ $? = 2 ] || fail "broken shader: exit is not 2"
grep -q 'shading.glsl:1: ' "$scratch/stderr" || fail "broken shader: no file and line: $(cat "$scratch/stderr")"

[ $failures = 0 ] && echo "headless: all good"
exit $((failures > 0))

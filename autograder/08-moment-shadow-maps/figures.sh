#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/08-moment-shadow-maps/figures.sh [BIN_DIR]
# The typical wrong picture comes from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/08-moment-shadow-maps/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] [image=NAME] mine FILE arguments…
mine() {
    local name=$1 image=${image:-color}
    shift
    "$bin/08-moment-shadow-maps.solution" render --size "${size:-384x384}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}

fixed="--set filter=fixed"

size=512x512 mine final --scene fence
image=shadow_map mine shadow-map --scene boxes
image=moments mine moments-raw --scene boxes --set storage=raw16
image=moments mine moments-quantized --scene boxes --set storage=quantized16
mine raw-bits --scene boxes $fixed --set storage=raw16 --set moment_bias=3e-6
mine too-little-bias --scene boxes $fixed --set storage=quantized16 --set moment_bias=3e-6
mine quantized --scene boxes $fixed --set storage=quantized16
mine float-sums --scene boxes --set prefilter=sat_cpu
mine float-sums-biased --scene boxes --set prefilter=sat_cpu --set moment_bias=3e-3
mine integer-sums --scene boxes
mine bias-none --scene boxes $fixed --set moment_bias=0
mine bias-right --scene boxes $fixed
mine bias-much --scene boxes $fixed --set moment_bias=1e-2
mine own-weight --scene boxes --layer "$here/wrong/own-weight-counted"
image=visibility mine no-plane --scene boxes --set receiver_plane=off
image=visibility mine with-plane --scene boxes
image=blocker_depth mine blocker-depth --scene boxes
mine no-refinement --scene fence --set refinements=0
mine refined --scene fence
image=visibility mine cells-1 --scene foliage
image=visibility mine cells-4 --scene foliage --set cells=4
"$bin/penumbra-truth" --scene foliage --size 384x384 --samples 256 --light square --out "$drawn/rays" >/dev/null
cp "$drawn/rays/visibility.png" "$given/figures/rays.png"
echo rays.png
"$bin/08-moment-shadow-maps.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

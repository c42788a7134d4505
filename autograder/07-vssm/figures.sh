#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/07-vssm/figures.sh [BIN_DIR]
# The typical wrong pictures come from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/07-vssm/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] [image=NAME] mine FILE arguments…
mine() {
    local name=$1 image=${image:-color}
    shift
    "$bin/07-vssm.solution" render --size "${size:-384x384}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}
wrong() { mine "$1" --layer "$here/wrong/$2" "${@:3}"; }

fixed="--set width=fixed"
wide="--set width=fixed --set filter_width=16 --set filter_cells=1"

size=512x512 mine final --scene stairs
image=moments mine moments --scene boxes
image=visibility mine center-mean --scene boxes --set map_size=2048 $fixed
image=visibility mine center-zero --scene boxes --set map_size=2048 $fixed --set center=zero
image=mean_variance mine mean-variance --scene boxes --set filter_width=24
image=mean_variance wrong box-off-by-one box-off-by-one --scene boxes --set filter_width=24
image=mean_variance wrong dark-border border-blocks --scene boxes --set filter_width=24
mine checkpoint --scene boxes $fixed
image=visibility wrong two-sided two-sided --scene boxes $fixed
image=visibility mine normal --scene boxes $fixed --set estimate=normal
image=blocker_depth mine blocker-depth --scene stairs
image=penumbra_width mine penumbra-width --scene stairs
image=penumbra_width wrong unguarded blocker-depth-unguarded --scene stairs
image=visibility mine one-query --scene fence --set queries=1
image=visibility mine two-queries --scene fence
image=visibility mine search-cells --scene fence --set search_cells=3
image=visibility mine bleeding --scene stairs $wide --set light_bleeding=0
image=visibility mine esm --scene stairs $wide --set estimate=esm --set exponent=60
image=visibility mine evsm --scene stairs $wide --set estimate=evsm --set exponent=20
"$bin/07-vssm.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/06-pcss/figures.sh [BIN_DIR]
# The typical wrong pictures come from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/06-pcss/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] [image=NAME] figure FILE PROGRAM arguments…
figure() {
    local name=$1 program=$2 image=${image:-color}
    shift 2
    "$bin/$program" render --size "${size:-384x384}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}
mine() { figure "$1" 06-pcss.solution "${@:2}"; }
wrong() { mine "$1" --layer "$here/wrong/$2" "${@:3}"; }

fixed="--set method=pcf"
few="--set search_samples=4 --set filter_samples=4"

size=512x512 mine final --scene stairs
figure unshadowed 06-pcss --scene boxes
image=shadow_map mine shadow-map --scene boxes
image=penumbra_width mine penumbra-width --scene boxes
image=blocker_depth mine blocker-depth --scene boxes
wrong radius-for-width radius-for-width --scene boxes
wrong linear-depth linear-depth --scene boxes
mine with-everything --scene boxes
mine final-pcf --scene stairs $fixed
mine no-plane --scene stairs $fixed --set receiver_plane=off
mine too-much-bias --scene stairs $fixed --set receiver_plane=off --set constant_bias=12
image=visibility mine no-horizon --scene boxes --set horizon=off
image=visibility mine with-horizon --scene boxes
mine checkpoint --scene fence $fixed
mine filtered-depth --scene fence --set method=filtered_depth --set map_size=256
mine fence --scene fence
wrong all-depths depths-averaged-with-unblocked --scene boxes
image=search mine search --scene boxes
image=min_depth mine min-depth --scene boxes
image=visibility mine kernel-grid --scene halfplane --set kernel=grid $few
image=visibility mine kernel-sheared --scene halfplane $few
image=visibility mine kernel-disk --scene halfplane --set kernel=disk $few
mine hidden-area --scene fence --set method=backprojection --set filter_samples=16

#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/05-shadow-map/figures.sh [BIN_DIR]
# The typical wrong pictures come from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/05-shadow-map/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] figure NAME IMAGE PROGRAM arguments…
figure() {
    local name=$1 image=$2 program=$3
    shift 3
    "$bin/$program" render --size "${size:-384x384}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}
mine() { figure "$1" color 05-shadow-map.solution "${@:2}"; }
wrong() { mine "$1" --layer "$here/wrong/$2" "${@:3}"; }

nearest="--set filter=off --set receiver_plane=off"
few="--set map_size=256"

size=512x512 mine final --scene stairs
figure shadow-map shadow_map 05-shadow-map.solution --scene stairs --set map_size=512
figure unshadowed color 05-shadow-map --scene stairs
figure loose-frustum color 05-shadow-map --scene stairs --layer "$root/solutions/05-shadow-map"
wrong ndc-depth ndc-depth --scene stairs
wrong no-divide-by-w no-divide-by-w --scene stairs
wrong v-flipped v-flipped --scene stairs
wrong checkpoint no-bias --scene stairs
wrong checkpoint-nearest no-bias --scene stairs --set filter=off
mine nearest --scene fence --set filter=off $few
mine two-by-two --scene fence --set filter=2x2 $few
wrong filter-then-compare filter-then-compare --scene fence --set filter=2x2 $few
mine peter-panning --scene fence $nearest --set map_size=512 --set constant_bias=16
mine lamp --scene "$given/lamp.gltf"
wrong behind-the-light no-test-behind-light --scene "$given/lamp.gltf"
wrong outside-is-shadow outside-is-shadow --scene "$given/lamp.gltf"
mine second-depth --scene stairs $nearest --set second_depth=on
wrong second-depth-alone midpoint-is-second-depth --scene foliage $nearest --set second_depth=on
"$bin/05-shadow-map.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

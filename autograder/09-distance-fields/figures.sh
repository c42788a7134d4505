#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/09-distance-fields/figures.sh [BIN_DIR]
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/09-distance-fields/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] [image=NAME] mine FILE arguments…
mine() {
    local name=$1 image=${image:-visibility}
    shift
    "$bin/09-distance-fields.solution" render --size "${size:-320x320}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}
rays() {
    "$bin/penumbra-truth" --size 320x320 --samples 256 --out "$drawn/$1" "${@:2}" >/dev/null
    cp "$drawn/$1/visibility.png" "$given/figures/$1.png"
    echo "$1.png"
}

size=512x512 image=color mine final --scene boxes
image=distance mine slice --scene boxes --set slice=0.3
image=steps mine steps --scene boxes --set method=hard --set max_steps=64
image=steps mine steps-penumbra --scene boxes --set method=lecture --set max_steps=64
image=color mine checkpoint --scene boxes --set method=lecture
mine lecture-blunt --scene boxes --set method=lecture --set k=1
mine lecture-sharp --scene boxes --set method=lecture --set k=4
mine lecture --scene boxes --set method=lecture
mine signed --scene boxes --set method=signed
rays rays-boxes --scene boxes
bands="--scene boxes --set method=lecture --set k=1 --set light_size=4"
mine bands $bands
mine bands-capped $bands --set step_cap=0.1
mine bands-closest $bands --set method=closest_approach
mine self-shadow --scene boxes --set grid=64 --set method=signed --set normal_offset=0 --set horizon=off
mine no-horizon --scene boxes --set method=signed --set horizon=off
mine leak-signed --scene stairs --set method=signed
mine leak-quarters --scene stairs
rays rays-stairs --scene stairs
mine fence-64 --scene fence --set grid=64
mine fence-128 --scene fence
mine fence-256 --scene fence --set grid=256
rays rays-fence --scene fence
mine foliage --scene foliage
rays rays-foliage --scene foliage
"$bin/09-distance-fields.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

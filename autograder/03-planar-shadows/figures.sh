#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/03-planar-shadows/figures.sh [BIN_DIR]
# The typical wrong pictures come from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/03-planar-shadows/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] [image=NAME] figure FILE PROGRAM arguments…
figure() {
    local name=$1 program=$2 image=${image:-color}
    shift 2
    "$bin/$program" render --size "${size:-320x320}" --image "$image" --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/$image.png" "$given/figures/$name.png"
    echo "$name.png"
}
mine() { figure "$1" 03-planar-shadows.solution "${@:2}"; }
# wrong FILE MISTAKE arguments…: of C++, a program of its own; of GLSL, a layer over the solution
wrong() {
    local program=03-planar-shadows.wrong.$2
    if [ -x "$bin/$program" ]; then figure "$1" "$program" "${@:3}"; else mine "$1" --layer "$here/wrong/$2" "${@:3}"; fi
}

bare="--set stencil=off"
half="--set alpha=0.5"

size=512x512 mine final --scene board@30
figure unshadowed 03-planar-shadows --scene boxes
mine ground --scene boxes --set form=ground $bare
wrong transposed matrix-transposed --scene boxes --set form=ground $bare
wrong last-entry last-entry-is-one --scene boxes --set form=ground $bare
mine matrix --scene board@30 --set form=matrix $bare
mine ground-on-board --scene board@30 --set form=ground
wrong sign-of-d sign-of-d --scene board@30 --set form=matrix
mine z-fighting --scene board@30 $bare --set depth_offset=0 $half
mine double --scene board@30 $bare $half
image=visibility mine double-visibility --scene board@30 $bare $half
wrong mark-stays mark-never-used-up --scene board@30 $half
wrong depth-test-on depth-tested --scene board@30 $half
image=visibility wrong no-marks no-stencil --scene board@30 $half
mine checkpoint --scene board@30 $half
image=stencil mine checkpoint-stencil --scene board@30 $half
mine mast --scene mast
mine false-shadow --scene mast --set clip=off
mine antishadow --scene mast --set clip=off --set divide=on
mine divided --scene mast --set divide=on
mine hollow --scene hollow
image=shadow_texture mine shadow-texture --scene hollow --set texture_size=512
wrong no-q-test no-test-of-q --scene hollow
wrong outside-is-dark outside-is-shadow --scene hollow
wrong smear border-goes-on --scene hollow
wrong v-flipped v-downwards --scene hollow
mine onto-casters --scene hollow --set onto_casters=on
mine texture-false-shadow --scene mast --set method=texture
mine coarse --scene hollow --set texture_size=256
"$bin/03-planar-shadows.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

#!/usr/bin/env bash
# Draws the handout's figures anew from a built tree:  autograder/04-shadow-volumes/figures.sh [BIN_DIR]
# The typical wrong pictures come from wrong/, so that figure and grader show the same mistake.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/dev/bin}" && pwd)
given=$root/assignments/04-shadow-volumes/given
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$given/figures"

# [size=WxH] figure NAME PROGRAM arguments…
figure() {
    local name=$1 program=$2
    shift 2
    "$bin/$program" render --size "${size:-360x360}" --image color --out "$drawn/$name" "$@" >/dev/null
    cp "$drawn/$name/color.png" "$given/figures/$name.png"
    echo "$name.png"
}
mine() { figure "$1" 04-shadow-volumes.solution "${@:2}"; }
# wrong FIGURE MISTAKE arguments…: a mistake in GLSL alone runs the solution's program.
wrong() {
    local program=04-shadow-volumes.solution
    if ls "$here/wrong/$2"/*.cpp >/dev/null 2>&1; then program=04-shadow-volumes.wrong.$2; fi
    figure "$1" "$program" --layer "$here/wrong/$2" "${@:3}"
}

size=768x512 mine final --scene courtyard
mine silhouettes --scene sun --set show=silhouettes
mine volumes --scene stairs --set show=volumes
mine counts --scene stairs --set show=counts
wrong direction-forgotten direction-forgotten --scene sun --set show=silhouettes
mine unwrong --scene boxes
wrong w-one w-one --scene boxes
for scene in eye_inside near_cut; do
    for method in zpass zfail; do mine "${scene/_/-}-$method" --scene "$scene" --set "method=$method"; done
done
wrong near-cap-missing near-cap-missing --scene boxes
wrong far-cap-missing far-cap-missing --scene stairs
wrong finite-far-plane finite-far-plane --scene boxes
wrong side-winding side-winding --scene stairs --set show=volumes
mine open-mesh --scene open_mesh
wrong facing-only facing-only --scene open_mesh
mine shut-lamp --scene shut_lamp
wrong light-inside light-inside --scene shut_lamp
size=384x256 wrong stencil-not-cleared stencil-not-cleared --scene courtyard
size=384x256 wrong replace-not-add replace-not-add --scene courtyard
size=384x256 wrong ambient-each-light ambient-each-light --scene courtyard
mine nested-255 --scene nested@255
mine nested-256 --scene nested@256
mine nested-float --scene nested@256 --set counter=float
wrong no-wrap no-wrap --scene nested@255
"$bin/04-shadow-volumes.grade" --curves --solution --out "$drawn/curves" >/dev/null
cp "$drawn"/curves/*.svg "$given/figures/"

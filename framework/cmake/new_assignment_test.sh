#!/bin/sh
# Adding an assignment edits no file. A scratch tree gets docs/new-assignment in its three folders and
# nothing else; scanning must find it, build it, list it, render it and grade it.
#
#   new_assignment_test.sh BUILD CMAKE GENERATOR      # BUILD: a build tree of this checkout
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 cmake=$2 generator=$3
name=90-attached-shadow
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "new_assignment_test.sh: $1" >&2; exit 1; }

tree=$scratch/tree
mkdir "$tree"
cp "$root/framework/cmake/new_assignment/CMakeLists.txt" "$tree"
"$cmake" -S "$tree" -B "$scratch/build" -G "$generator" -DPENUMBRA_FACTS="$build/submission/framework.cmake" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; fail "the empty tree does not configure"; }

# From here on as docs/new-assignment.md says. Building looks at the folders again by itself.
cp -R "$root"/docs/new-assignment/* "$tree"
"$cmake" --build "$scratch/build" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "it does not build"; }
bin=$scratch/build/bin
for program in "$name" "$name.solution" "$name.grade"; do
    [ -x "$bin/$program" ] || fail "$program was not found by scanning"
done

"$bin/$name" list
"$bin/$name.solution" render --scene boxes --size 64x64 --out "$scratch/frame"
for file in visibility.exr visibility.png color.exr color.png depth.exr frame.json; do
    [ -s "$scratch/frame/$file" ] || fail "no $file"
done
"$(dirname "$cmake")/ctest" --test-dir "$scratch/build" -L grader --output-on-failure || fail "its own tests do not pass"

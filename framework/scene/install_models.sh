#!/bin/sh
# Installs the course's models into models/: downloads Debian's sweethome3d-furniture (120 MB, once),
# converts what models.json lists and writes models/ATTRIBUTION.md. Does nothing when all is there.
#
#   framework/scene/install_models.sh [path/to/penumbra-install-models]
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$root/build/dev/bin/penumbra-install-models}
manifest=$root/framework/scene/models.json
models=$root/models
scratch=$root/build/models
package=sweethome3d-furniture

fail() { echo "install_models.sh: $1" >&2; exit 2; }
checksum() { if command -v sha256sum >/dev/null; then sha256sum "$1"; else shasum -a 256 "$1"; fi | cut -d' ' -f1; }

stamp=$(checksum "$manifest")
if [ "$(cat "$models/.installed" 2>/dev/null)" = "$stamp" ]; then
    missing=0
    for name in $(sed -n 's/.*"name": "\([^"]*\)".*/\1/p' "$manifest"); do
        [ -f "$models/$name.glb" ] || missing=1
    done
    [ $missing = 0 ] && exit 0
fi
[ -x "$program" ] || fail "$program is missing: build the target penumbra-install-models first"
command -v unzip >/dev/null || fail "unzip is missing: install it (apt-get install unzip)"

mkdir -p "$scratch"
cd "$scratch"
if ! ls ${package}_*.deb >/dev/null 2>&1; then
    command -v apt-get >/dev/null ||
        fail "models come from Debian's package $package: put its .deb into $scratch"
    echo "models: downloading $package (120 MB)"
    rm -rf download
    mkdir download
    # In a folder of its own, so that a broken download is never taken for the package. -o: no warning where the
    # folder is root's alone.
    (cd download && apt-get -q -o APT::Sandbox::User=root download $package >../download.log 2>&1) ||
        fail "cannot download $package: run apt-get update and look at $scratch/download.log"
    mv download/*.deb .
    rm -rf download
fi
deb=$(ls ${package}_*.deb | tail -n 1)

echo "models: unpacking"
rm -rf unpacked archives converted.part
mkdir unpacked
if command -v dpkg-deb >/dev/null; then
    dpkg-deb -x "$deb" unpacked
else
    ar -p "$deb" data.tar.xz | tar -xJf - -C unpacked
fi
for archive in $(sed -n 's/.*"archive": "\([^"]*\)".*/\1/p' "$manifest" | sort -u); do
    mkdir -p "archives/$archive"
    unzip -q -o "unpacked/usr/share/sweethome3d/furniture/$archive.sh3f" -d "archives/$archive"
done

echo "models: converting"
PENUMBRA_ROOT=$root "$program" archives converted.part

# Whole files only: renamed one by one, the stamp last.
mkdir -p "$models"
for file in converted.part/*; do
    cp "$file" "$models/.incoming"
    mv "$models/.incoming" "$models/$(basename "$file")"
done
echo "$stamp" >"$models/.incoming"
mv "$models/.incoming" "$models/.installed"
rm -rf unpacked archives converted.part
echo "models: $(ls "$models"/*.glb | wc -l | tr -d ' ') in $models"

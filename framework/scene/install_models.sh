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
package=sweethome3d-furniture_1.8-1_all.deb
url=http://deb.debian.org/debian/pool/main/s/sweethome3d-furniture/$package
sum=3ccb90c63f9525e887a767b9cd5c8b6933b8b6b2973a615a5359ee68a2118668

fail() { echo "install_models.sh: $1" >&2; exit 2; }
sha256() { if command -v sha256sum >/dev/null; then sha256sum "$1"; else shasum -a 256 "$1"; fi | cut -d' ' -f1; }
genuine() { [ -f "$1" ] && [ "$(sha256 "$1")" = "$sum" ]; }

stamp="$sum $(sha256 "$manifest")"
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
if ! genuine "$package"; then
    echo "models: downloading $package (120 MB)"
    rm -f "$package" "$package.part"
    # apt's own mirror first; -o: no warning where the download folder is root's alone
    if command -v apt-get >/dev/null && apt-get -q -o APT::Sandbox::User=root download sweethome3d-furniture=1.8-1 >download.log 2>&1; then
        :
    elif command -v curl >/dev/null; then
        curl -fsSL -o "$package.part" "$url" || fail "cannot download $url: check the network"
        mv "$package.part" "$package"
    else
        fail "cannot download sweethome3d-furniture: run apt-get update, or install curl"
    fi
    genuine "$package" || fail "$scratch/$package is not the expected file: remove it and try again"
fi

echo "models: unpacking"
rm -rf unpacked archives converted.part
mkdir unpacked
if command -v dpkg-deb >/dev/null; then
    dpkg-deb -x "$package" unpacked
else
    ar -p "$package" data.tar.xz | tar -xJf - -C unpacked
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

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The installed program and the one in the Debian package need no file of the repository:
# install_test.sh BUILD_FOLDER SOURCE_FOLDER.
set -euo pipefail
build=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $1"; shift; (($# == 0)) || cat "$@"; exit 1; }

runs() {  # PROGRAM: it can tell what the machine offers, and draw
  "$1" doctor > doctor.txt 2>&1 || fail "$1 doctor" doctor.txt
  grep -q '^OpenGL' doctor.txt || fail "$1 doctor does not tell of OpenGL" doctor.txt
  "$1" render lecture-grid --frames 1 --size 320x180 --out "$1-frames" > render.txt 2>&1 || fail "$1 render" render.txt
  [[ -s $1-frames/frame_00000.png ]] || fail "$1 render: no picture" render.txt
  ! grep -qF "$source" "$1" || fail "$1 names the folder $source"
}

cmake --install "$build" --prefix "$folder/installed" > install.txt || fail "cmake --install" install.txt
runs "$folder/installed/bin/ballpit"
expected="bin/ballpit share/doc/ballpit/CHANGELOG.md share/doc/ballpit/README.md share/doc/ballpit/copyright"
found=$(cd installed && find . -type f -not -path './bin/ballpit-frames/*' | sed 's|^\./||' | LC_ALL=C sort | paste -sd ' ')
[[ $found == "$expected" ]] || fail "installed: found $found, expected $expected"

# cpack of a build folder that it must not write into.
cpack --config "$build/CPackConfig.cmake" -B "$folder" > cpack.txt 2>&1 || fail cpack cpack.txt
dpkg-deb -x ballpit_*.deb unpacked
runs "$folder/unpacked/usr/bin/ballpit"
depends=$(dpkg-deb -f ballpit_*.deb Depends)
for package in libegl1 libgl1-mesa-dri libepoxy0 libtbb12; do
  [[ $depends == *"$package"* ]] || fail "the package does not depend on $package: $depends"
done

#!/bin/sh
# Usage: make_kit.sh BUILD_FOLDER VERSION
#
# Makes BUILD_FOLDER/candela-VERSION-linux-ARCHITECTURE.tar.xz.
set -eu

here=$(dirname "$(realpath "$0")")
source=$(realpath "$here/../..")
build=$(realpath "$1")
version=$2
work=$build/kit
name=candela-$version-linux-$(uname -m)

sh "$here/build_libraries.sh" "$work/libraries"
cmake -S "$source" -B "$work/program" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DBUILD_TESTING=OFF -DCANDELA_PYTHON_MODULE=OFF -DCANDELA_VIEWER=OFF -DCANDELA_STATIC_LIBRARIES=ON \
  -DCMAKE_PREFIX_PATH="$work/libraries/root"
cmake --build "$work/program" --target candela

# A library without an archive would be linked as a shared one.
needed=$(objdump -p "$work/program/candela" | sed -n 's/.*NEEDED *//p' | grep -v -e '^libc\.so' -e '^libm\.so' -e '^ld-linux' || true)
[ -z "$needed" ] || { echo "make_kit.sh: the program needs $needed" >&2; exit 1; }

rm -rf "${work:?}/$name"
mkdir -p "$work/$name/scenes"
strip -o "$work/$name/candela" "$work/program/candela"
cp "$here/run.sh" "$here/README.md" "$source/LICENSE" "$work/$name"
cp -r "$source/host/drivers/conformance/baselines" "$work/$name"
cp "$source"/scenes/cornell.p3f "$source"/scenes/balls.p3f "$source"/scenes/primitives.p3f "$work/$name/scenes"

# Equal sources give equal files: the order and the dates of the files are fixed.
date=$(git -C "$source" log -1 --format=%cI 2>/dev/null || echo 2026-01-01)
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="$date" -C "$work" -cJf "$build/$name.tar.xz" "$name"
echo "$build/$name.tar.xz: $(stat -c %s "$build/$name.tar.xz") bytes"

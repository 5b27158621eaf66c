#!/bin/sh
# usage: check_kit.sh BUILD WORK: makes the kit, examines its program, and runs its script from an unpacked archive.
set -eu
build=$1
work=$2
rm -rf "$work"
mkdir -p "$work"
cmake --build "$build" --target kit > "$work/build.log" 2>&1 || { tail -50 "$work/build.log"; exit 1; }
archive=$(ls "$build"/candela-*-linux-*.tar.xz)
bytes=$(stat -c %s "$archive")
[ "$bytes" -le 26214400 ] || { echo "the kit has $bytes bytes, more than 25 MiB"; exit 1; }
tar -C "$work" -xf "$archive"
kit=$(ls -d "$work"/candela-*)

# A symbol that the program defined for others would replace that of a driver's C++ library.
defined=$(objdump -T "$kit/candela" | grep -v '\*UND\*' | grep -E '_Z|GLIBCXX' || true)
[ -z "$defined" ] || { echo "the program exports C++ symbols:"; echo "$defined"; exit 1; }
newest=$(objdump -T "$kit/candela" | grep -o 'GLIBC_2\.[0-9]*' | sort -t. -k2 -n -u | tail -n 1)
[ "$(printf '%s\n' "${newest#GLIBC_2.}" 36 | sort -n | tail -n 1)" = 36 ] || { echo "the program needs $newest"; exit 1; }

"$kit/run.sh" --quick -o "$work/results"
grep -q '"schema": "candela-kit/2"' "$work/results/results.json"
grep -q '| cornell.p3f |' "$work/results/results.md"
! grep -q 'exit code' "$work/results/results.md"

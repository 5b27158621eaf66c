#!/bin/sh
# Builds Candela for 64-bit ARM on another processor, and runs tests in QEMU's user mode.
#   sh cmake/arm64/check.sh                  the program, quick tests of the reference, and its recorded films by `path`
#   sh cmake/arm64/check.sh all [ARGUMENTS]  all tests that run in the emulator (arguments go to ctest)
# The native build in build/release computes the tables of energies, since that takes minutes in the emulator.
set -eu

cd "$(dirname -- "$0")/../.."
say() { printf 'arm64: %s\n' "$*" >&2; }

for tool in aarch64-linux-gnu-g++ qemu-aarch64; do
  command -v $tool >/dev/null || { say "there is no $tool; on Debian: apt-get install g++-aarch64-linux-gnu qemu-user"; exit 1; }
done
[ -d build/arm64-root ] || sh cmake/arm64/make_root.sh
[ -e build/release/build.ninja ] || cmake -S . --preset release >/dev/null
cmake --build build/release --target candela_make_energy_tables candela_make_anisotropic_tables >/dev/null
cmake -S . --preset arm64 -DBUILD_TESTING=ON -DCANDELA_NATIVE_BUILD="$PWD/build/release" >/dev/null
if [ "${1:-}" = all ]; then
  shift
  cmake --build build/arm64 >/dev/null
  exec ctest --preset arm64 -j "$(nproc)" "$@"
fi
cmake --build build/arm64 --target candela test_base test_reference >/dev/null
# Furnaces and means take most of the time of test_reference.
exec ctest --preset arm64 -j "$(nproc)" -R '^(test_base:|test_reference:|guard: path films of the reference)' -E 'furnace|preserves the mean'

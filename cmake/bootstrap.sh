#!/bin/sh
# Installs the missing packages of cmake/packages.txt on Debian 12 or 13, configures, builds, and then
#   sh cmake/bootstrap.sh test [ARGUMENTS]   runs all tests (arguments go to ctest)
#   sh cmake/bootstrap.sh ARGUMENTS          runs candela with these arguments
# The environment may choose a preset of CMakePresets.json (CANDELA_PRESET, default: release) and, for the first build,
# a compiler (CXX) and its options (CXXFLAGS).
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
preset=${CANDELA_PRESET:-release}
build=$root/build/$preset
list=$root/cmake/packages.txt

say() { printf 'bootstrap: %s\n' "$*" >&2; }

# Prints the packages that the program needs and, with "test", those of the tests, too.
packages() {
  if [ "$1" = test ]; then
    sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$list"
  else
    sed -e '/# test/d' -e 's/#.*//' -e '/^[[:space:]]*$/d' "$list"
  fi
}

missing_packages() {
  wanted=$(packages "$1")
  # shellcheck disable=SC2086 # one word per package
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' || true)
  for package in $wanted; do
    printf '%s\n' "$installed" | grep -qxF -- "$package" || printf '%s ' "$package"
  done
}

# The command that runs another one as root; fails if there is none.
root_command() {
  if [ "$(id -u)" = 0 ]; then
    echo env
  elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    echo sudo -n env
  elif command -v sudo >/dev/null && [ -t 0 ]; then
    echo sudo env
  else
    return 1
  fi
}

install_packages() {
  if ! as_root=$(root_command); then
    say "these packages are missing, and installing them needs root. Run this, then try again:"
    printf 'apt-get update && apt-get install -y --no-install-recommends %s\n' "$1" >&2
    exit 1
  fi
  say "installing $1"
  log=$(mktemp)
  # shellcheck disable=SC2086 # one word per package, and per part of the command
  if ! { $as_root apt-get update -q && $as_root DEBIAN_FRONTEND=noninteractive \
         apt-get install -q -y --no-install-recommends $1; } >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    say "apt-get failed, see above"
    exit 1
  fi
  rm -f "$log"
  rm -f "$build/build.ninja" # configure anew: CMake may find more now
}

# Without dpkg, libraries cannot be looked up: CMake names the first missing one.
require_tools() {
  missing=
  for tool in c++ cmake ninja glslangValidator; do
    command -v "$tool" >/dev/null || missing="$missing $tool"
  done
  [ -z "$missing" ] && return
  say "this is not Debian, so nothing is installed; missing tools:$missing"
  say "libraries that are needed, by their Debian names: $(packages "$1" | tr '\n' ' ')"
  exit 1
}

require_packages() {
  if ! command -v dpkg-query >/dev/null; then
    require_tools "$1"
    return
  fi
  missing=$(missing_packages "$1")
  [ -z "$missing" ] || install_packages "$missing"
}

# Runs a step silently; its output is shown if it fails.
quietly() {
  if ! "$@" >"$build/bootstrap.log" 2>&1; then
    cat "$build/bootstrap.log" >&2
    say "failed: $*"
    exit 1
  fi
}

tests_configured() { grep -qs '^BUILD_TESTING:[A-Z]*=ON$' "$build/CMakeCache.txt"; }

# Configures if this has not been done yet, with tests if $1 is ON. A build that has tests keeps them.
configure() {
  tests=$1
  if tests_configured; then
    tests=ON
  elif [ "$tests" = ON ]; then
    rm -f "$build/build.ninja"
  fi
  [ -e "$build/build.ninja" ] || quietly cmake -S "$root" --preset "$preset" "-DBUILD_TESTING=$tests"
}

build_target() {
  mkdir -p "$build"
  [ -x "$build/candela" ] || say "building (the first time takes minutes)"
  configure "$2"
  quietly cmake --build "$build" --target "$1"
}

if [ $# = 0 ]; then
  sed -n 's/^# \{0,1\}//; 2,6p' "$0" >&2
  exit 1
fi

if [ "$1" = test ]; then
  shift
  require_packages test
  build_target all ON
  cd "$root"
  exec ctest --preset "$preset" -j "$(nproc)" "$@"
fi
require_packages run
build_target candela OFF
exec "$build/candela" "$@"

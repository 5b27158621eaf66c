#!/usr/bin/env bash
# usage: action.sh install | check: the two steps of action.yml.
# CANDELA_KIT is the path or URL of an archive of the kit, or empty: then the program is built. CANDELA_ARGUMENTS are the
# arguments of candela, with quotes as in a shell.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
kit=${CANDELA_KIT:-}
folder=${RUNNER_TEMP:-/tmp}/candela-kit

# Installs a software device where no device can be used.
install_driver() {
  local as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo -n)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" apt-get install -q -y --no-install-recommends mesa-vulkan-drivers libvulkan1
}

unpack_kit() {
  rm -rf "$folder"
  mkdir -p "$folder"
  if [[ $kit == *://* ]]; then
    curl --fail --location --silent --show-error --output "$folder.tar.xz" "$kit"
    kit=$folder.tar.xz
  fi
  tar -C "$folder" --strip-components=1 -xf "$kit"
  [ -x "$folder/candela" ] || { echo "action: $kit is no archive of the kit: it contains no candela" >&2; exit 1; }
}

candela() {
  if [ -n "$kit" ]; then "$folder/candela" "$@"; else sh "$root/cmake/bootstrap.sh" "$@"; fi
}

case ${1:-} in
  install)
    if [ -n "$kit" ]; then
      unpack_kit
      "$folder/candela" devices > /dev/null 2>&1 || install_driver
    fi
    candela --version
    ;;
  check)
    lines=$(xargs -r printf '%s\n' <<< "${CANDELA_ARGUMENTS:-}")
    mapfile -t arguments <<< "$lines"
    candela "${arguments[@]}"
    ;;
  *)
    sed -n 's/^# \{0,1\}//; 2p' "${BASH_SOURCE[0]}" >&2
    exit 1
    ;;
esac

#!/bin/sh
# Makes build/arm64-root, the folder with the arm64 packages of Debian that the preset `arm64` compiles and runs with.
#   sh cmake/arm64/make_root.sh
# apt-get downloads the packages of cmake/packages.txt for the host's release of Debian into lists of packages of their own, so that
# this needs no root and leaves the packages of the host as they are. The folder is made anew whenever the script runs.
set -eu

source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
root=$source/build/arm64-root
work=$root.work

say() { printf 'make_root: %s\n' "$*" >&2; }

# The libraries in cmake/packages.txt; the other packages there are tools, which are the host's.
libraries() {
  sed -e '/# test/d' -e 's/#.*//' -e '/^[[:space:]]*$/d' "$source/cmake/packages.txt" |
    grep -vxE 'g\+\+|cmake|ninja-build|ccache|pkg-config|glslang-tools'
  printf '%s\n' catch2 libc6-dev
}

for tool in apt-get dpkg-deb; do
  command -v "$tool" >/dev/null || { say "this needs Debian: there is no $tool"; exit 1; }
done

rm -rf "$root" "$work"
mkdir -p "$work/state/lists/partial" "$work/cache/archives/partial" "$work/root/usr/bin" "$work/root/usr/sbin" "$work/root/usr/lib"
: >"$work/state/status" # no package is installed
cat >"$work/apt.conf" <<END
APT::Architecture "arm64";
APT::Architectures { "arm64"; };
APT::Install-Recommends "false";
APT::Sandbox::User "";
Dir::State "$work/state";
Dir::State::status "$work/state/status";
Dir::Cache "$work/cache";
END
log=$work/log
# shellcheck disable=SC2046 # one word per package
if ! { APT_CONFIG=$work/apt.conf apt-get update -q &&
       APT_CONFIG=$work/apt.conf apt-get install -q -y --download-only $(libraries); } >"$log" 2>&1; then
  cat "$log" >&2
  say "apt-get failed, see above"
  exit 1
fi

# Debian's merged /usr, so that no file is in two places.
for folder in bin sbin lib; do
  ln -s "usr/$folder" "$work/root/$folder"
done
for package in "$work"/cache/archives/*.deb; do
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$work/root" --no-same-owner --keep-directory-symlink
done
# Links to absolute paths would lead out of the folder.
find "$work/root" -type l -lname '/*' | while read -r link; do
  ln -sfn "$(realpath -ms --relative-to="$(dirname "$link")" "$work/root$(readlink "$link")")" "$link"
done
# draco's CMake files name the folders into which its package is installed.
sed -i 's|"/usr|"${CMAKE_SYSROOT}/usr|' "$work/root/usr/lib/aarch64-linux-gnu/cmake/draco/"*.cmake
mv "$work/root" "$root"
rm -rf "$work"
say "made $root"

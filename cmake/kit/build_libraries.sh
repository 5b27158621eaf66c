#!/bin/sh
# Usage: build_libraries.sh FOLDER
#
# Builds, from the sources of the Debian release on which it runs, archives of the libraries that Debian has only as shared ones, and
# installs them in FOLDER/root. It needs no root privileges, and does not change apt's package lists. Existing archives are not built again.
set -eu

folder=$(realpath -m "$1")
root=$folder/root
. /etc/os-release

# Runs apt-get with separate lists and a separate cache.
apt_get() {
  apt-get -qq -o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=- \
    -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" -o APT::Sandbox::User="$(id -un)" "$@"
}

# The sources are signed by the keys of Debian's archive.
list_sources() {
  mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
  key=/usr/share/keyrings/debian-archive-keyring.gpg
  {
    echo "deb-src [signed-by=$key] http://deb.debian.org/debian $VERSION_CODENAME main"
    echo "deb-src [signed-by=$key] http://deb.debian.org/debian-security $VERSION_CODENAME-security main"
  } > "$folder/apt/sources.list"
  apt_get update
}

# build NAME [CMAKE_OPTION...]: builds Debian's source package NAME.
build() {
  name=$1
  shift
  test ! -e "$folder/$name.done" || return 0
  test -e "$folder/apt/sources.list" || list_sources
  rm -rf "$folder/$name"
  mkdir -p "$folder/$name/download"
  (cd "$folder/$name/download" && apt_get source --download-only "$name")
  dpkg-source --no-check -x "$folder/$name/download/"*.dsc "$folder/$name/source" > "$folder/$name/unpack.log"
  cmake -S "$folder/$name/source" -B "$folder/$name/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    -DBUILD_TESTING=OFF -DCMAKE_PREFIX_PATH="$root" -DCMAKE_INSTALL_PREFIX="$root" -DCMAKE_INSTALL_LIBDIR=lib "$@"
  cmake --build "$folder/$name/build" --target install
  touch "$folder/$name.done"
}

mkdir -p "$folder"
build fmtlib -DFMT_DOC=OFF -DFMT_TEST=OFF
build imath
build openexr -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF
build meshoptimizer
build pugixml

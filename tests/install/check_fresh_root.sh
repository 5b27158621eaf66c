#!/bin/sh
# usage: check_fresh_root.sh WORK PACKAGES [RELEASE [KIT]]
# Makes a bare Debian system of RELEASE (default: this machine's) below WORK with debootstrap, installs the Debian packages of the
# folder PACKAGES there with apt-get, uses them as a newcomer would, and removes them. With KIT, an archive of the kit, its script
# is then run in the same system, which has a Vulkan driver but none of the packages that a build needs. Needs root and a mirror of
# Debian, and leaves the pictures and the kit's results in WORK.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)

# Mounts end with the namespace in which they were made.
if [ "${CANDELA_FRESH_ROOT:-}" != mounted ]; then
  CANDELA_FRESH_ROOT=mounted exec unshare --mount -- sh "$0" "$@"
fi
work=$1
packages=$2
release=${3:-$(. /etc/os-release && echo "$VERSION_CODENAME")}
kit=${4:-}
root=$work/root

command -v debootstrap > /dev/null || { echo "debootstrap is not installed: apt-get install debootstrap"; exit 1; }
rm -rf "$work"
mkdir -p "$work"
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
debootstrap --variant=minbase "$release" "$root" "${mirror:-http://deb.debian.org/debian}" > "$work/debootstrap.log" 2>&1 ||
  { tail -20 "$work/debootstrap.log"; exit 1; }
cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/"
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
mkdir "$root/packages"
cp "$packages"/candela_*.deb "$packages"/python3-candela_*.deb "$root/packages/"
cp "$here/use_packages.sh" "$root/packages/"
chroot "$root" sh /packages/use_packages.sh
mv "$root/packages/"*.png "$work/"
[ -z "$kit" ] && exit

tar -C "$root/packages" -xf "$kit"
chroot "$root" sh -c 'cd /packages/candela-*/ && ./run.sh --quick -o /packages/results'
mv "$root/packages/results" "$work/"
grep -q '| cornell.p3f |' "$work/results/results.md"
! grep -q 'exit code' "$work/results/results.md"

#!/bin/sh
# usage: check_packages.sh BUILD WORK: makes the Debian packages, examines them with lintian, and unpacks and uses them.
set -eu
build=$1
work=$2
rm -rf "$work"
mkdir -p "$work"
(cd "$build" && cpack -B "$work" > "$work/cpack.log" 2>&1) || { cat "$work/cpack.log"; exit 1; }
for package in "$work"/*.deb; do
  lintian --allow-root --fail-on error "$package" || { echo "$package: lintian found errors"; exit 1; }
  dpkg -x "$package" "$work/root"
done
"$work/root/usr/bin/candela" --version
if [ -e "$work"/python3-candela_*.deb ]; then
  (cd / && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$work/root/usr/lib/python3/dist-packages "${PYTHON:-/usr/bin/python3}" -c "
import candela
film = candela.render(candela.load('$work/root/usr/share/candela/scenes/cornell.p3f'), spp=1, size=(16, 16), device='cpu')
assert film.image.mean() > 0.01 and candela.__file__.startswith('$work')")
fi
"$work/root/usr/bin/candela" check "$work/root/usr/share/candela/scenes/cornell.p3f" > /dev/null
for file in man/man1/candela-verify.1.gz bash-completion/completions/candela zsh/vendor-completions/_candela \
  fish/vendor_completions.d/candela.fish applications/candela.desktop mime/packages/candela.xml doc/candela/copyright; do
  [ -s "$work/root/usr/share/$file" ] || { echo "usr/share/$file is missing"; exit 1; }
done
dpkg -f "$work"/candela_*.deb Depends | grep -q libvulkan1 || { echo "the package does not depend on libvulkan1"; exit 1; }

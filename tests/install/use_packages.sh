#!/bin/sh
# Installs the packages beside this file on a bare Debian system, uses them, and removes them without a trace.
set -eu
cd "$(dirname "$0")"
export DEBIAN_FRONTEND=noninteractive

apt-get update -q > apt.log
apt-get install -q -y --no-install-recommends ./candela_*.deb ./python3-candela_*.deb mesa-vulkan-drivers man-db >> apt.log 2>&1 ||
  { tail -30 apt.log; exit 1; }
dpkg -L candela python3-candela | sort -u > installed.txt

# As README and the manual describe it.
candela doctor
candela render /usr/share/candela/scenes/balls.p3f -o balls.png --spp 16 --size 256x256
candela generate still-life -o still.gltf
candela still.gltf --env sun:35,220,3 --exposure auto --size 150x100 --spp 16 --denoise -o still.png
candela verify /usr/share/candela/scenes/mirror.p3f --size 64x64
man -P cat candela > /dev/null
python3 -c "
import candela
film = candela.render(candela.load('/usr/share/candela/scenes/cornell.p3f'), spp=4, size=(64, 64))
film.save('python.png')
assert film.image.shape == (64, 64, 3) and film.image.mean() > 0.01"

apt-get purge -q -y candela python3-candela >> apt.log 2>&1
while read -r file; do
  [ -d "$file" ] || [ ! -e "$file" ] || { echo "$file is left after the packages were removed"; exit 1; }
done < installed.txt

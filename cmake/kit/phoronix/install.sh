#!/bin/sh
# Installs the profile from the kit's archive, whose path is in the environment variable CANDELA_KIT.
if ! tar -xf "${CANDELA_KIT:?set it to the path of candela-VERSION-linux-x86_64.tar.xz}" --strip-components=1; then
  echo 1 > ~/install-exit-status
  exit 1
fi
mkdir -p made
cp scenes/cornell.p3f made
./candela generate cornell -o made/box-with-balls.p3f
./candela generate balls --size 5 -o made/spheres.p3f
./candela generate terrain -o made/terrain.p3f
./candela verify scenes/cornell.p3f --size 64x64
echo $? > ~/install-exit-status

cat > candela-benchmark <<'END'
#!/bin/sh
./candela bench "made/$1.p3f" --size 512x512 --spp 16 --repeat 1 --json result.json > "$LOG_FILE" 2>&1
echo $? > ~/test-exit-status
sed -n 's/^ *"msamplesPerSecond": \([0-9.e+-]*\),*$/Result: \1 Msamples\/s/p' result.json >> "$LOG_FILE"
END
chmod +x candela-benchmark

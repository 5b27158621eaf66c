#!/bin/sh
# Measures whether a Vulkan device computes the right light, and how fast it is. Writes results.json, results.md and
# results.svg. It needs a Vulkan driver; no installation, no network, no privileges. It takes a few minutes on a GPU.
set -u

usage() {
  cat <<'END'
Usage: ./run.sh [--device SELECTOR] [--quick | --full] [-o FOLDER]

  --device SELECTOR  index or part of the name of a device in `./candela devices` (default: the best GPU)
  --quick, --full    small or large images (default: small images if the device is a software device)
  -o FOLDER          folder for the results, which is created (default: results)
END
}

wrong_usage() {
  echo "run.sh: $1" >&2
  usage >&2
  exit 1
}

kit=$(cd "$(dirname "$0")" && pwd) || exit 1
out=results
device=
size=
while [ $# -gt 0 ]; do
  case $1 in
    --device) [ $# -gt 1 ] || wrong_usage "--device: an argument is missing"; device=$2; shift ;;
    -o) [ $# -gt 1 ] || wrong_usage "-o: an argument is missing"; out=$2; shift ;;
    --quick) size=quick ;;
    --full) size=full ;;
    -h | --help) usage; exit 0 ;;
    *) wrong_usage "$1: unknown option" ;;
  esac
  shift
done

mkdir -p "$out" || exit 2
out=$(cd "$out" && pwd)
work=$(mktemp -d) || exit 2
running=  # the process of the current step

# A shell that waits for a process in the foreground handles signals only when the process has ended. A step runs in the
# background, in a process group of its own, and is ended first.
interrupted() {
  trap '' HUP INT TERM
  if [ -n "$running" ]; then
    kill "$running" 2> /dev/null
    wait "$running" 2> /dev/null
  fi
  echo "run.sh: interrupted, and no results are written" >&2
  exit 7
}
trap 'rm -rf "$work"' EXIT
trap interrupted HUP INT TERM

# The kit measures the behaviour for a new user: settings that `candela tune` stored on this machine, and compiled pipelines, have no effect.
export CANDELA_CACHE_DIR="$work/cache"
candela() { "$kit/candela" "$@"; }

# All devices, without results if there is none.
if ! candela devices --json "$work/devices.json" > /dev/null; then
  echo "run.sh: the Vulkan devices cannot be listed. \`$kit/candela doctor\` says why." >&2
  exit 4
fi
# The one device that all steps use, without results if it does not exist or cannot be used.
if [ -z "$device" ]; then
  device=$(awk '/"index":/ { gsub(/[^0-9]/, ""); at = $0 } /"default": true/ { print at }' "$work/devices.json")
fi
if [ -n "$device" ]; then
  candela devices --device "$device" --json "$work/device.json" > /dev/null || exit
else
  echo "run.sh: no Vulkan device is usable. \`$kit/candela doctor\` says why." >&2
  exit 4
fi
if [ -z "$size" ]; then
  size=quick
  if grep -q '"type": ".*GPU"' "$work/device.json"; then size=full; fi
fi
patience=1
if [ "$size" = full ]; then
  pixels=1024x1024 spp=16 verify_size=256x256
else
  pixels=128x128 spp=4 verify_size=64x64 patience=4  # times as long may a step take
fi

# Prints the first line of an error: the program's, else that of another one, such as a driver.
cause() {
  line=$(sed -n 's/^candela: //p' "$1" | head -n 1)
  printf '%s' "${line:-$(head -n 1 "$1")}"
}

# step NAME SECONDS ARGUMENT...: runs the program for at most SECONDS times $patience, with the report $work/NAME.json.
step() {
  name=$1
  limit=$(($2 * patience))
  shift 2
  printf '%s ... ' "$name"
  started=$(date +%s)
  timeout --kill-after=10 "$limit" "$kit/candela" "$@" --device "$device" --quiet --json "$work/$name.json" > /dev/null 2> "$work/$name.err" &
  running=$!
  wait "$running"
  code=$?
  running=
  seconds=$(($(date +%s) - started))
  case $code in
    0) echo "done ($seconds s)" ;;
    3) echo "differences found ($seconds s)" ;;
    8) echo "not decided ($seconds s)" ;;
    124 | 137) echo "not finished after $limit s" ;;
    *) echo "failed with exit code $code: $(cause "$work/$name.err")" ;;
  esac
  steps="${steps:+$steps, }{\"name\": \"$name\", \"exitCode\": $code, \"seconds\": $seconds}"
}

# Prints the reports of steps as a JSON array, with null for steps without a report.
reports() {
  separator=
  for name in "$@"; do
    printf '%s' "$separator"
    if [ -s "$work/$name.json" ]; then cat "$work/$name.json"; else printf null; fi
    separator=', '
  done
}

# Prints a text as a JSON string.
json_text() { printf '"%s"' "$(printf '%s' "$1" | tr -d '\000-\037' | sed 's/[\\"]/\\&/g')"; }

steps=
skips=
if grep -q '"name": ".*SwiftShader' "$work/device.json"; then skips="$kit/baselines/swiftshader-skips.txt"; fi
step conformance 240 conformance ${skips:+--skips "$skips"}
for scene in cornell balls primitives; do
  step "verify-$scene" 120 verify "$kit/scenes/$scene.p3f" --size $verify_size --untuned --time-limit 30s
done

cp "$kit/scenes/cornell.p3f" "$work/cornell.p3f"
candela generate cornell -o "$work/box-with-balls.p3f"
candela generate sphere -o "$work/room.p3f"
candela generate balls -o "$work/spheres.p3f" --size 5
if [ $size = full ]; then candela generate terrain -o "$work/terrain.p3f"; else candela generate terrain --size 100 -o "$work/terrain.p3f"; fi
scenes="cornell box-with-balls room spheres terrain"
for scene in $scenes; do
  step "bench-$scene" 60 bench "$work/$scene.p3f" --size $pixels --spp $spp --untuned \
    --sweep kernel=megakernel,wavefront --sweep layout=bvh2,cwbvh --sweep loads=texel,storage
done
for scene in room spheres terrain; do
  step "rays-$scene" 60 bench rays "$work/$scene.p3f" --size $pixels
done
step tune 120 tune --dry-run

processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)
system=$(sed -n 's/^PRETTY_NAME="\{0,1\}\([^"]*\)"\{0,1\}$/\1/p' /etc/os-release 2> /dev/null)
quick=true
if [ $size = full ]; then quick=false; fi
{
  printf '{"schema": "candela-kit/2", "version": %s, ' "$(json_text "$(candela --version | sed 's/^candela //')")"
  printf '"system": %s, ' "$(json_text "${system:-Linux}, kernel $(uname -r)")"
  printf '"processor": %s, "quick": %s, "steps": [%s],\n' "$(json_text "${processor:-unknown}")" $quick "$steps"
  printf '"devices": %s,\n' "$(reports devices)"
  printf '"conformance": %s,\n' "$(reports conformance)"
  printf '"verify": [%s],\n' "$(reports verify-cornell verify-balls verify-primitives)"
  printf '"bench": [%s],\n' "$(reports bench-cornell bench-box-with-balls bench-room bench-spheres bench-terrain)"
  printf '"rays": [%s],\n' "$(reports rays-room rays-spheres rays-terrain)"
  printf '"tune": %s}\n' "$(reports tune)"
} > "$work/results.json"

# A report shows that the file is complete, before it replaces an older one.
candela report "$work/results.json" --markdown "$work/results.md" --svg "$work/results.svg" || exit 70
mv "$work/results.json" "$work/results.md" "$work/results.svg" "$out" || exit 2
echo "The results are $out/results.json, results.md and results.svg."

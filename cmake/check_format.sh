#!/bin/sh
# Fails if a C++ file of host/, lists/ or tests/ is not formatted as by clang-format 14, and names the file. Other versions format
# differently: without version 14 nothing is checked, and the exit code is 77, which ctest reports as a skipped test.
#   sh cmake/check_format.sh         checks
#   sh cmake/check_format.sh --fix   rewrites the files instead
set -eu
cd "$(dirname -- "$0")/.."

formatter=
for name in clang-format-14 clang-format; do
  if command -v "$name" >/dev/null && "$name" --version | grep -q 'version 14\.'; then
    formatter=$name
    break
  fi
done
if [ -z "$formatter" ]; then
  echo "SKIPPED: the format was NOT checked, since clang-format 14 is not installed (Debian 12: apt-get install clang-format)"
  exit 77
fi

if [ "${1-}" = --fix ]; then
  set -- -i
else
  set -- --dry-run --Werror --ferror-limit=1
fi
find host include lists tests \( -name '*.cpp' -o -name '*.h' -o -name '*.hpp' \) -exec "$formatter" "$@" {} +

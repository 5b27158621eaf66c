#!/bin/sh
# Completes command lines with fish, which prints its completions.
command -v fish > /dev/null || { echo "fish is not installed: apt-get install fish"; exit 1; }
export HOME="$(mktemp -d)"
failures=0
expect() {  # expect LINE EXPECTED: the words that complete the line. fish 4 also offers words that only contain the last one.
  found=$(fish -c "source '$folder/candela.fish'; complete -C '$1'" | cut -f1 | grep -e "^${1##* }" | sort | tr '\n' ' ')
  [ "$found" = "$2 " ] || { echo "$1: found '$found', expected '$2'"; failures=1; }
}
folder=$1
expect "candela ver" "verify"
expect "candela verify --te" "--test"
expect "candela verify --test " "independent paired"
expect "candela generate --si" "--size"
expect "candela scene.p3f --nee " "off on"
exit $failures

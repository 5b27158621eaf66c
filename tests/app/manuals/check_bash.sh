#!/bin/sh
# Completes command lines with bash as a user would, by the function that the file defines.
exec bash -u -s "$(realpath "$1")" <<'SCRIPT'
source "$1/candela.bash"
failures=0
expect() {  # expect WORDS... -- EXPECTED: the completions of the last word
  COMP_WORDS=()
  while [[ $1 != == ]]; do COMP_WORDS+=("$1"); shift; done
  shift
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _candela
  [[ "${COMPREPLY[*]}" == "$*" ]] || { echo "${COMP_WORDS[*]}: found '${COMPREPLY[*]}', expected '$*'"; failures=1; }
}
cd "$(mktemp -d)"
touch scene.p3f
mkdir folder
expect candela ve == verify
expect candela verify --te == --test
expect candela verify --test "" == paired independent
expect candela generate material-t == material-table
expect candela scene.p3f --nee "" == on off
expect candela scene.p3f --allow-path f == folder
expect candela verify s == scene.p3f
expect candela devices --sp ==
exit $failures
SCRIPT

#!/bin/sh
# usage: check_action.sh SOURCE: runs the steps of action.yml as a runner does, once with arguments that pass and once with some that fail.
set -eu
export GITHUB_ACTION_PATH=$1
steps=$(sed -n 's/^ *run: //p' "$GITHUB_ACTION_PATH/action.yml")
[ "$(printf '%s\n' "$steps" | wc -l)" = 2 ] || { echo "action.yml has not two steps"; exit 1; }
run_steps() {
  CANDELA_ARGUMENTS=$1
  export CANDELA_ARGUMENTS
  printf '%s\n' "$steps" | while IFS= read -r step; do bash --noprofile --norc -eo pipefail -c "$step" || exit $?; done
}
run_steps "conformance --cases leaf.film.*"
run_steps "verify $GITHUB_ACTION_PATH/scenes/balls.p3f --size 16x16 --bias 5% --quiet"
# Quotes keep the spaces of an argument, and nothing is expanded.
message=$(run_steps "conformance --cases 'no case' --device \"a  b\" --junit c\\ d/*.xml" 2>&1) && exit 1
printf '%s\n' "$message" | grep -qF 'no case: no case has such a name' || { echo "quotes are lost: $message"; exit 1; }
message=$(run_steps "conformance --cases leaf.film.sums --device \"a  b\"" 2>&1) && exit 1
printf '%s\n' "$message" | grep -qF '"a  b"' || { echo "spaces are lost: $message"; exit 1; }
code=0
run_steps "conformance --cases 'none" 2> /dev/null || code=$?
[ "$code" = 1 ] || { echo "an unmatched quote ended with $code, not 1"; exit 1; }
code=0
run_steps "conformance --cases none" 2> /dev/null || code=$?
[ "$code" = 1 ] || { echo "wrong arguments ended with $code, not 1"; exit 1; }

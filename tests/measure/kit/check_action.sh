#!/bin/sh
# usage: check_action.sh SOURCE PROGRAM WORK: runs the steps of action.yml as a runner does, with arguments that pass and with some that
# fail; once as they are, and once with an archive that contains PROGRAM as the kit.
set -eu
export GITHUB_ACTION_PATH=$1
program=$2
work=$3
export CANDELA_KIT=
steps=$(sed -n 's/^ *run: //p' "$GITHUB_ACTION_PATH/action.yml")
[ "$(printf '%s\n' "$steps" | wc -l)" = 2 ] || { echo "action.yml has not two steps"; exit 1; }
run_steps() {
  CANDELA_ARGUMENTS=$1
  export CANDELA_ARGUMENTS
  printf '%s\n' "$steps" | while IFS= read -r step; do bash --noprofile --norc -eo pipefail -c "$step" || exit $?; done
}
check_arguments() {
  run_steps "conformance --cases leaf.film.*"
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
}
check_arguments
run_steps "verify $GITHUB_ACTION_PATH/scenes/balls.p3f --size 16x16 --bias 5% --quiet"

rm -rf "$work"
mkdir -p "$work/candela-1.0" "$work/empty-1.0" "$work/temporary files"
export RUNNER_TEMP="$work/temporary files"
cp "$program" "$work/candela-1.0/candela"
tar -C "$work" -cf "$work/kit.tar" candela-1.0
tar -C "$work" -cf "$work/empty.tar" empty-1.0
CANDELA_KIT=$work/kit.tar
# Nothing is built, and no program of the source folder is used.
real=$GITHUB_ACTION_PATH
GITHUB_ACTION_PATH=$work/action
mkdir -p "$GITHUB_ACTION_PATH/cmake/kit"
cp "$real/cmake/kit/action.sh" "$GITHUB_ACTION_PATH/cmake/kit"
check_arguments
for CANDELA_KIT in "$work/no.tar" "$work/empty.tar" "file://$work/no.tar"; do
  code=0
  message=$(run_steps devices 2>&1) || code=$?
  [ "$code" != 0 ] || { echo "$CANDELA_KIT was accepted"; exit 1; }
done
CANDELA_KIT=file://$work/kit.tar
run_steps "conformance --cases leaf.film.sums"
rm -rf "$work"

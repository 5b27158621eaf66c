#!/bin/sh
# Loads the completion with zsh's own system: a syntax error, or an option specification that it rejects, is an error.
command -v zsh > /dev/null || { echo "zsh is not installed: apt-get install zsh"; exit 1; }
exec zsh -f -s "$(realpath "$1")" <<'SCRIPT'
setopt errexit extendedglob
folder=$1
zsh -n $folder/_candela
fpath=($folder $fpath)
zmodload zsh/zpty
zpty shell "zsh -f -i"
zpty -w shell "PS1='ready> '; fpath=($folder \$fpath); autoload -U compinit; compinit -u -D; bindkey '^I' complete-word"
send() {  # send LINE: what the terminal shows after the line and a tab
  zpty -n -w shell "$1"$'\t'
  sleep 0.5
  shown=
  while zpty -r -t shell part; do shown+=$part; done
  shown=${${shown//$'\e'\[[0-9]#[a-zA-Z]}//[[:cntrl:]]}  # without bells, colours and what moves the cursor
  zpty -n -w shell $'\C-u'
}
sleep 1
while zpty -r -t shell part; do :; done
failures=0
expect() {
  for attempt in 1 2 3; do
    send "$1"
    [[ $shown == *$2* ]] && return
    sleep 1
  done
  print -r -- "$1: the terminal shows '$shown', expected '$2'"
  failures=1
}
expect "candela verif" "candela verify"
expect "candela verify --tes" "--test"
expect "candela verify --test in" "independent"
expect "candela film --tonem" "--tonemap"
zpty -d shell
exit $failures
SCRIPT

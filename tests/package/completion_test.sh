#!/usr/bin/env bash
# What the completion offers for a line: argument: the script that makes it.
set -eu
. "$1"
cd "$(mktemp -d)"
mkdir pictures
: > mine.md

# expect LINE WORDS: what is offered at the end of the line, parted by blanks, is just this.
failed=0
expect() {
  COMP_LINE=$1
  COMP_POINT=${#1}
  # bash parts at '=' too.
  read -ra COMP_WORDS <<< "${1//=/ = }"
  [[ $1 == *' ' || $1 == *= ]] && COMP_WORDS+=("")
  [[ $1 == *= ]] && unset 'COMP_WORDS[-1]'
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _moltact || true  # compopt fails outside of a completion
  if [[ "${COMPREPLY[*]-}" != "$2" ]]; then
    echo "\"$1\" offers \"${COMPREPLY[*]-}\" and not \"$2\"" >&2
    failed=1
  fi
}

expect 'moltact re' 'replay render report'
expect 'moltact new' 'new-lesson'
expect 'moltact render --them' '--theme'
expect 'moltact render 1ubq --theme ' 'light dark'
expect 'moltact render 1ubq --theme=d' 'dark'
expect 'moltact render 1ubq --theme=' 'light dark'
expect 'moltact render 1ub' '1ubq'
expect 'moltact info m' 'mine.md'
expect 'moltact --language ' 'en de fr'
expect 'moltact info 1ubq --model ' ''
expect 'moltact device ' 'check record replay path'
expect 'moltact device check --s' '--seconds'
expect 'moltact bench --svg ' 'pictures'
expect 'moltact check p' 'pictures'
expect 'moltact check m' 'mine.md'
expect 'moltact bench s' 'stability'
exit $failed

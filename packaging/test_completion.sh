#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Asks the completion what a shell would, with clipc on the PATH.
#   packaging/test_completion.sh FILE
. /usr/share/bash-completion/bash_completion
. "$1"

# expect WORD... -- ANSWER...: the answers are among what completes the last word of the line.
expect() {
  local line=() answer
  while [ "$1" != -- ]; do line+=("$1") && shift; done
  shift
  # readline splits the line so that `=` is a word of its own.
  local text="clipc ${line[*]}"
  read -ra COMP_WORDS <<<"${text//=/ = }"
  [ -n "${line[-1]}" ] || COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMP_LINE=$text COMP_POINT=${#text} COMPREPLY=()
  _clipc
  for answer in "$@"; do
    printf '%s\n' "${COMPREPLY[@]}" | grep -qxF -- "$answer" || {
      echo "completion of \`$text\`: no \`$answer\` among ${COMPREPLY[*]}" >&2
      exit 1
    }
  done
}

compopt() { :; } # there is no line to complete
expect --plane -- --plane-space=
expect -Zp -- -Zpc -Zpr
expect --lower=n -- near-plane none
expect --target=essl -- essl100 essl300 essl310 essl320
expect -T vs_5 -- vs_5_0 vs_5_1
expect -T ps_5 -- ps_5_0 ps_5_1
cd "$(dirname "$0")/../examples/first" && expect wat -- water.hlsl

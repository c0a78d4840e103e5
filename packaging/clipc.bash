# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# bash completion for clipc. The options are those of `clipc --help` and their values those that clipc answers with, so nothing
# here changes with the program.

# The words that clipc offers in its answer to an unknown value.
_clipc_values() {
  "$@" /dev/null -o - 2>&1 | sed -n 's/.*; there is //p' | grep -o '`[^`]*`' | tr -d '`'
}

_clipc() {
  local cur prev words cword split
  _init_completion -s || return
  local program=${words[0]}
  case $prev in
    # The first letter says the stage whose profiles clipc answers with.
    -T) mapfile -t COMPREPLY < <(compgen -W "$(_clipc_values "$program" -T "${cur:0:1}?")" -- "$cur") ;;
    -E | -D | -U | -j | -Vn) ;;
    --fragment | --pixel-shader | --table | --reflect | --batch | --index | --sandbox-includes | --depfile) _filedir ;;
    --*)
      if $split; then
        mapfile -t COMPREPLY < <(compgen -W "$(_clipc_values "$program" "$prev=?")" -- "$cur")
        return
      fi
      ;;&
    *)
      if [[ $cur != -* ]]; then
        _filedir
        return
      fi
      local options
      options=$("$program" --help 2>/dev/null | sed -nE 's/^  (-[^ <]*).*/\1/p')
      mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
      if [[ ${COMPREPLY[0]-} == *= ]]; then compopt -o nospace; fi
      ;;
  esac
} && complete -F _clipc clipc

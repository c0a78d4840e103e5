#!/bin/sh
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs a Windows program under Wine, with no window.
#   wine.sh PREFIX PROGRAM [ARGUMENT...]
# PREFIX is Wine's folder; one that does not exist is made, which takes some seconds.
WINEPREFIX=$1
shift
# No messages of its own, no dialogues that ask for Mono or Gecko, no menu entries.
WINEARCH=win64 WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe='
# Wine wants a home to write to.
HOME=$WINEPREFIX LC_ALL=C.UTF-8 PATH=$PATH:/usr/lib/wine
export WINEPREFIX WINEARCH WINEDEBUG WINEDLLOVERRIDES HOME LC_ALL PATH
unset DISPLAY
[ -d "$WINEPREFIX" ] || mkdir -p "$WINEPREFIX"
# Wine's server stays for a while: starting it takes longer than a program runs. Its services would keep the standard streams of
# the program that they come with, and so the end of a pipe from who reads it.
server=$(command -v wineserver64 || command -v wineserver)
(
  flock 9
  if "$server" -p20 9>&-; then # there was none
    wine64 wineboot 9>&-
  fi
) 9>"$WINEPREFIX/lock" </dev/null >/dev/null 2>&1
exec wine64 "$@"

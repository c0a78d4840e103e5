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
# Wine's server stays for a while: starting it takes longer than a program runs. One that is there is left as it is.
for server in wineserver64 wineserver; do
  if command -v $server >/dev/null; then
    $server -p20 </dev/null >/dev/null 2>&1 || true
    break
  fi
done
exec wine64 "$@"

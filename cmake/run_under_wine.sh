#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs a Windows program on a display of its own and Mesa's software driver; leaves no process behind.
#   run_under_wine.sh WINE WINESERVER XVFB PREFIX PROGRAM [ARGUMENT...]
# PREFIX is Wine's folder. One that does not exist is made, which takes some seconds, and removed, since it is large.
set -euo pipefail
wine=$1 wineserver=$2 xvfb=$3
export WINEPREFIX=$4
shift 4
export WINEARCH=win64 WINEDEBUG=-all LIBGL_ALWAYS_SOFTWARE=1
# No dialogues that ask for Mono or Gecko, no menu entries.
export WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe='
made=no
# Wine wants a home to write to.
[ -d "$WINEPREFIX" ] || {
  mkdir -p "$WINEPREFIX"
  made=yes
}
export HOME=$WINEPREFIX

xvfb_process=
finish() {
  timeout -k 5 20 "$wineserver" -k 2>/dev/null || true
  [ -z "$xvfb_process" ] || kill "$xvfb_process" 2>/dev/null || true
  [ $made = no ] || rm -rf "$WINEPREFIX"
}
trap finish EXIT
trap 'exit 143' TERM INT

# Xvfb picks a free display and tells its number.
number=$(mktemp)
"$xvfb" -displayfd 9 -screen 0 640x480x24 -nolisten tcp 9>"$number" >/dev/null 2>&1 &
xvfb_process=$!
for _ in $(seq 100); do
  [ ! -s "$number" ] || break
  kill -0 "$xvfb_process" 2>/dev/null || break
  sleep 0.1
done
DISPLAY=:$(tr -d '[:space:]' <"$number")
export DISPLAY
rm -f "$number"
if [ "$DISPLAY" = : ]; then
  echo "run_under_wine.sh: Xvfb did not start" >&2
  exit 1
fi

# In the background, so that a signal is not kept waiting.
timeout -k 10 200 "$wine" "$@" </dev/null &
wait $!

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The whole builds for other platforms and their tests take a quarter of an hour each. cmake/cross/tested has, for each platform, a
# hash of the files that its build alone is made of, as they were when its tests passed last.
#   cmake/cross/tested.sh is-tested PLATFORM    exits 0 if those files are the same now
#   cmake/cross/tested.sh passed PLATFORM       writes their hash
set -euo pipefail
cd "$(dirname "$0")/../.."
list=cmake/cross/tested
case $2 in
  web) paths=(web compiler/compile/list_spirv.h compiler/compile/validate.h link/read.h) ;; # no_glslang.cpp stands in for the three
  windows) paths=(cmake/windows base/system.h base/system_windows.cpp compiler/library runtime/d3d9) ;;
esac
hash=$(git ls-files -z -- "${paths[@]}" cmake/cross ":!$list" | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -c 1-16)
case $1 in
  is-tested) grep -qxF "$2 $hash" "$list" ;;
  passed)
    others=$(grep -v "^$2 " "$list" || true)
    printf '%s\n' ${others:+"$others"} "$2 $hash" | sort >"$list"
    ;;
esac

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs a test of what web/build.sh makes: if_built.sh COMMAND... Status 77, which is to skip it: that was not made, or a source
# is newer.
set -euo pipefail
cd "$(dirname "$0")/../.."
made=build/web/made
if [ ! -f "$made" ]; then
  echo "nothing is built for the web; \`./test --web\` builds it"
  exit 77
fi
newer=$(find base ir frontend passes legalize backend-glsl backend-spirv clip-table link rewrite compiler runtime cmake/cross \
  web/build.sh web/module web/wasm web/npm web/page web/examples examples/gallery study/tables/speed.csv \
  -newer "$made" -type f -regex '.*\.\(cpp\|h\|def\|js\|ts\|css\|html\|json\|cmake\|sh\|csv\|hlsl\|fx\)' -not -name '*_test.cpp' -print -quit)
if [ -n "$newer" ]; then
  echo "$newer is newer than what is built for the web; \`./test --web\` builds it"
  exit 77
fi
exec "$@"

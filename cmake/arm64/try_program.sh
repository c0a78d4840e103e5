#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs the program for 64-bit ARM under an emulator, and says where it writes other bytes than those that examples/ has of another machine.
#   cmake/arm64/try_program.sh CLIPC
set -euo pipefail
clipc=$(realpath "$1")
cd "$(dirname "$0")/../.."
emulator=$(command -v qemu-aarch64-static || command -v qemu-aarch64)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/clipc" <<END
#!/bin/sh
exec "$emulator" "$clipc" "\$@"
END
chmod +x "$scratch/clipc"
python3 examples/check_gallery.py "$scratch/clipc"

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Sourced by run and test, in the repository's root.

llvm=${CLIPC_LLVM:-19}

# What building clipc takes, and what testing it takes on top.
build_packages=(g++ cmake ninja-build ccache "libclang-$llvm-dev" "llvm-$llvm-dev" libfmt-dev nlohmann-json3-dev glslang-dev spirv-headers)
# clang-format-19 is pinned: other versions write other text.
test_packages=(python3 clang-format-19 valgrind "llvm-$llvm-tools" libgtest-dev libgmock-dev glslang-tools spirv-tools spirv-cross
  libvulkan-dev mesa-vulkan-drivers vulkan-validationlayers libspirv-cross-c-shared-dev
  libepoxy-dev libegl1 libopengl0 libgles2 libgl1-mesa-dri libpng-dev)

# What the laboratory takes on top of building clipc: `./run study` and `./test --study` install it.
study_packages=(python3 libepoxy-dev libegl1 libopengl0 libgles2 libgl1-mesa-dri libpng-dev libtinygltf-dev python3-matplotlib)

# What opens pages in tests.
browser_packages=(chromium)

# What `./test --all` installs too: clang-tidy, and what testing the Direct3D 9 binding takes, without which CTest has
# no entry `d3d9.*`.
ci_packages=(clang-tidy-19 g++-mingw-w64-x86-64-win32 wine64 libwine xvfb libgl1 libglx-mesa0)

# packaging/test_packages.sh, packaging/slurm, examples/builds and the reference of the headers take these.
package_packages=(doxygen debootstrap lintian dpkg-dev man-db bash-completion pkg-config make meson bazel-bootstrap
  munge slurmctld slurmd slurm-client)

# Building clipc for WebAssembly takes these; `./run page` and `./test --web` install them. Neither installs node 20 or newer:
# Debian 12 has an older one.
web_packages=(clang-19 lld-19 llvm-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 binaryen python3
  spirv-headers dpkg-dev)

# Building clipc for Windows and testing it under Wine takes these; `./test --windows` installs them.
windows_packages=(g++-mingw-w64-x86-64-posix wine64 libwine libclang-19-dev llvm-19-dev googletest python3 spirv-headers
  dpkg-dev)

# Building clipc for 64-bit ARM takes these, and cmake/arm64/fetch_libraries.sh, which installs nothing.
arm64_packages=(python3 g++-aarch64-linux-gnu qemu-user-static)

# quietly COMMAND...: runs it and shows what it printed only if it fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  [ "$status" -eq 0 ] || cat "$log" >&2
  rm -f "$log"
  return "$status"
}

# install_packages NAME...: installs the Debian packages that are missing, and says nothing when none is.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    return 0 # Not Debian: CMake says what it misses.
  fi
  local installed missing=() package as_root=()
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
  for package in "$@"; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return 0
  fi
  echo "Installing ${missing[*]} ..." >&2
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}")
  # Most machines have a list of packages that is good enough; a fresh one has none.
  "${install[@]}" >/dev/null 2>&1 || {
    quietly "${as_root[@]}" apt-get update -qq
    quietly "${install[@]}"
  }
}

# install_node_packages: what the page is made of and what tools/checks/check_scripts.py runs, as web/page/package-lock.json pins it,
# in build/web/page.
install_node_packages() {
  mkdir -p build/web/page
  cp web/page/{package.json,package-lock.json,.npmrc} build/web/page
  [ build/web/page/node_modules -nt web/page/package-lock.json ] || (cd build/web/page && quietly npm ci --no-audit --no-fund)
}

# configure_preset NAME TESTING: configures build/NAME unless that was done for the same LLVM. TESTING is ON or OFF; with OFF, a
# build folder with tests is good too.
configure_preset() {
  local cache=build/$1/CMakeCache.txt
  if [ -f "build/$1/build.ninja" ] && grep -q "^CLIPC_LLVM:[A-Z]*=$llvm\$" "$cache" &&
    { [ "$2" = OFF ] || grep -q '^BUILD_TESTING:[A-Z]*=ON' "$cache"; }; then
    return 0
  fi
  quietly cmake --preset "$1" -DBUILD_TESTING="$2" -DCLIPC_LLVM="$llvm"
}

# build_preset NAME [cmake --build arguments]
build_preset() {
  local preset=$1
  shift
  cmake --build "build/$preset" "$@" | sed '/^ninja: no work to do/d; /Re-checking globbed directories/d'
}

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Debian's cross compiler for 64-bit ARM, and the libraries that cmake/arm64/fetch_libraries.sh puts into build/arm64-root.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

cmake_path(SET CLIPC_ARM64_ROOT NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../build/arm64-root)
set(CMAKE_FIND_ROOT_PATH ${CLIPC_ARM64_ROOT} /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Programs are static, so that they run where there is an emulator and nothing else.
find_program(CLIPC_QEMU NAMES qemu-aarch64-static qemu-aarch64)
mark_as_advanced(CLIPC_QEMU)
if(CLIPC_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${CLIPC_QEMU})
endif()

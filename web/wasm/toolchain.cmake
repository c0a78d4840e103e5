# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Clang and Debian's C and C++ libraries for WebAssembly: apt-get install clang-19 lld-19 wasi-libc libc++-19-dev-wasm32
# libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 binaryen.
set(CMAKE_SYSTEM_NAME Generic)  # CMake 3.25 does not know WASI
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CLIPC_WASM ON)
set(CLIPC_FROM_SOURCES ON)

set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_AR llvm-ar-19 CACHE FILEPATH "")
set(CMAKE_RANLIB llvm-ranlib-19 CACHE FILEPATH "")
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX .wasm)

# include/ has what these libraries lack; see ../../docs/decisions/0010-webassembly.md.
set(shims ${CMAKE_CURRENT_LIST_DIR}/include)
set(emulated "-D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_MMAN -D_WASI_EMULATED_GETPID -D_WASI_EMULATED_PROCESS_CLOCKS")
set(CMAKE_C_FLAGS_INIT "-isystem ${shims} -include ${shims}/posix.h ${emulated} -fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -fexperimental-library")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L/usr/lib/llvm-19/lib/wasm32-wasi")

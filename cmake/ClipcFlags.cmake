# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What every target is compiled with: language, warnings, floating point, build types, sanitizers.

option(CLIPC_WERROR "warnings are errors" ${PROJECT_IS_TOP_LEVEL})
set(static_by_default ON)
if(APPLE)
  set(static_by_default OFF)  # its C library is shared only
endif()
option(CLIPC_STATIC "link the release executable fully static: it starts in less than half the time" ${static_by_default})
set(CLIPC_SANITIZE "" CACHE STRING "sanitizers, as -fsanitize= takes them: address,undefined")
set(CLIPC_PROFILE "" CACHE STRING "`record`: programs note what they run; `use`: they are compiled by these notes (cmake/build_profiled.sh)")
set(CLIPC_LINK_ORDER "" CACHE FILEPATH "the symbols of the functions that a short run calls, a line each: lld links them side by side")
option(CLIPC_FUZZ "instrument everything for libFuzzer and build tools/fuzz/ (needs Clang)" OFF)

get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT CMAKE_BUILD_TYPE AND NOT multi_config)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()

# Programs in bin/, whatever folder makes them; test binaries stay beside their library.
set(CLIPC_BIN ${CMAKE_BINARY_DIR}/bin)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# With notes of what runs, -O3 makes only that larger; without, it lengthens the build by more than it gains. What is downloaded is
# small first.
if(CLIPC_PROFILE)
  set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
elseif(CLIPC_WASM)
  set(CMAKE_CXX_FLAGS_RELEASE "-Oz -DNDEBUG")
else()
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_compile_options(-Wall -Wextra)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  add_compile_options(-Wno-deprecated-declarations)  # libstdc++ 12's own std::stable_sort calls a deprecated function
endif()
if(CLIPC_WERROR)
  add_compile_options(-Werror)
endif()

# The evaluator computes what a shader computes, rounding by rounding: a fused multiply-add rounds once only, and g++ 12's SLP
# vectoriser drops a double -> float -> double round trip under -mavx.
add_compile_options(-ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fno-tree-slp-vectorize)
endif()

# Objects name their sources from the repository's root: two folders give the same bytes, and share ccache's.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options("-fmacro-prefix-map=${clipc_SOURCE_DIR}/=")
endif()

# Every object may become a part of a shared library, of ours or of an application's plugin, and names stay inside it: only what
# CLIPC_API marks is seen from outside. With hidden names position-independent code costs nothing in a static program.
if(NOT CLIPC_WASM)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fno-gnu-unique>)  # names that no tool could make local
endif()

add_compile_options(-ffunction-sections -fdata-sections)
if(APPLE)
  add_link_options(LINKER:-dead_strip)
else()
  add_link_options(LINKER:--gc-sections)
endif()
add_compile_definitions($<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)

set(sanitizers ${CLIPC_SANITIZE})
if(CLIPC_FUZZ)
  list(APPEND sanitizers fuzzer-no-link)
endif()
if(sanitizers)
  list(JOIN sanitizers , sanitizers)
  # No `vptr`: it looks at the type information of glslang's classes, and glslang is built without.
  add_compile_options(-fsanitize=${sanitizers} -fno-sanitize=vptr -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-maybe-uninitialized)  # GCC 12 finds one in its own <regex> as soon as it instruments it
  endif()
endif()

# Notes lie beside the objects, so that both builds must be in one folder.
if(CLIPC_PROFILE AND NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  message(FATAL_ERROR "CLIPC_PROFILE is for g++, and this is ${CMAKE_CXX_COMPILER_ID}")
endif()
if(CLIPC_PROFILE STREQUAL "record")
  add_compile_options(-fprofile-generate -fprofile-update=single)
  add_link_options(-fprofile-generate)
elseif(CLIPC_PROFILE STREQUAL "use")
  # A compile runs through most of its code once: it waits for the code more than for the loops in it. So the longer forms that
  # -fprofile-use gives to loops are left out: with them, a compile runs fewer instructions and takes more time. Code without notes is
  # compiled for speed like the rest. With notes, g++ 12 gives these two warnings where nothing is wrong.
  add_compile_options(-fprofile-use -fprofile-partial-training -fno-unroll-loops -fno-peel-loops -fno-split-loops -fno-unswitch-loops
    -fno-tree-loop-vectorize -fno-gcse-after-reload -fno-tracer -fno-ipa-cp-clone
    -Wno-missing-profile -Wno-maybe-uninitialized -Wno-restrict)
elseif(CLIPC_PROFILE)
  message(FATAL_ERROR "CLIPC_PROFILE is `record` or `use`, not `${CLIPC_PROFILE}`")
endif()

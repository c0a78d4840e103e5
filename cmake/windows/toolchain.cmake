# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# mingw-w64 with POSIX threads, for Windows on x86-64: apt-get install g++-mingw-w64-x86-64-posix. A mingw-w64 for the Universal C
# Runtime is taken where there is one: Debian 13 has it, g++-mingw-w64-ucrt64; Debian 12's programs use msvcrt.dll, which every
# Windows has.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CLIPC_FROM_SOURCES ON)

find_program(CLIPC_UCRT_CXX NAMES x86_64-w64-mingw32ucrt-g++-posix x86_64-w64-mingw32ucrt-g++)
mark_as_advanced(CLIPC_UCRT_CXX)
if(CLIPC_UCRT_CXX)
  set(triplet x86_64-w64-mingw32ucrt)
else()
  set(triplet x86_64-w64-mingw32)
endif()
set(suffix "")
find_program(CLIPC_POSIX_CXX NAMES ${triplet}-g++-posix)
mark_as_advanced(CLIPC_POSIX_CXX)
if(CLIPC_POSIX_CXX)
  set(suffix -posix)
endif()
set(CMAKE_C_COMPILER ${triplet}-gcc${suffix})
set(CMAKE_CXX_COMPILER ${triplet}-g++${suffix})
set(CMAKE_RC_COMPILER ${triplet}-windres)

set(CMAKE_FIND_ROOT_PATH /usr/${triplet})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# LLVM's configuration, which comes before that of the installed headers.
set(CLIPC_LLVM_CONFIG ${CMAKE_CURRENT_LIST_DIR}/include)
# Offsets in files have 64 bits, as LLVM's own build has it. An object with templates may have more than 65,000 sections.
set(CMAKE_C_FLAGS_INIT "-D_FILE_OFFSET_BITS=64 -Wa,-mbig-obj")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
# Programs need no other file than Windows' own, and have the stack of Linux: clipc's limits on nesting expect it. The same
# sources give the same bytes.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--stack,8388608 -Wl,--no-insert-timestamp")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -Wl,--no-insert-timestamp")

# Tests run under Wine where this system has it.
set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_CURRENT_LIST_DIR}/wine.sh ${CMAKE_BINARY_DIR}/wine)

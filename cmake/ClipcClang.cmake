# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `clang_slice`: Clang's preprocessor and lexer, and what they need of LLVM, as static archives named by path. Never Clang's
# own CMake targets: their link interface is the shared libLLVM, which costs 17 ms at every start, and Debian's name programs
# of packages that need not be installed.

set(CLIPC_LLVM 19 CACHE STRING "the LLVM to build with: 19 or 22")
set(CLIPC_LLVM_PREFIX "" CACHE PATH "where that LLVM is installed; otherwise Clang_DIR, LLVM_DIR and CMAKE_PREFIX_PATH say so, \
or it is in the place of Debian or Homebrew")

# The folder of find_package's files is PREFIX/lib/cmake/clang, in vcpkg PREFIX/share/clang.
set(prefixes)
foreach(folder IN ITEMS ${Clang_DIR} ${LLVM_DIR})
  list(APPEND prefixes ${folder}/../../.. ${folder}/../..)
endforeach()
set(usual /usr/lib/llvm-${CLIPC_LLVM} /opt/homebrew/opt/llvm@${CLIPC_LLVM} /usr/local/opt/llvm@${CLIPC_LLVM}
  /opt/homebrew/opt/llvm /usr/local/opt/llvm)
set(only)
if(CLIPC_LLVM_PREFIX)
  set(prefixes ${CLIPC_LLVM_PREFIX})
  set(usual)
  set(only NO_DEFAULT_PATH)
endif()

# A folder with another LLVM is passed over.
function(clipc_is_llvm result file)
  file(STRINGS ${file} version REGEX "CLANG_VERSION_MAJOR ${CLIPC_LLVM}$")
  if(NOT version)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_file(clang_version clang/Basic/Version.inc HINTS ${prefixes} PATHS ${usual} PATH_SUFFIXES include ${only}
  VALIDATOR clipc_is_llvm NO_CACHE)
cmake_path(SET clang_include ${clang_version})
foreach(part Version.inc Basic clang)
  cmake_path(GET clang_include PARENT_PATH clang_include)
endforeach()
cmake_path(GET clang_include PARENT_PATH clang_prefix)

set(archives clangFrontend clangEdit clangLex clangBasic LLVMTargetParser LLVMSupport LLVMDemangle)
foreach(archive IN LISTS archives)
  find_library(found_${archive} NAMES lib${archive}.a ${archive} PATHS ${clang_prefix}/lib NO_DEFAULT_PATH NO_CACHE)
  if(NOT clang_version OR NOT found_${archive})
    message(FATAL_ERROR "no libraries of Clang ${CLIPC_LLVM} in ${CLIPC_LLVM_PREFIX}; CLIPC_LLVM_PREFIX or CMAKE_PREFIX_PATH says "
      "where they are; on Debian: apt-get install libclang-${CLIPC_LLVM}-dev llvm-${CLIPC_LLVM}-dev")
  endif()
endforeach()

find_package(Threads REQUIRED)
add_library(clang_slice INTERFACE)
target_include_directories(clang_slice SYSTEM INTERFACE ${clang_include})
foreach(archive IN LISTS archives)
  target_link_libraries(clang_slice INTERFACE ${found_${archive}})
endforeach()
target_link_libraries(clang_slice INTERFACE Threads::Threads)
if(WIN32)
  target_link_libraries(clang_slice INTERFACE ole32 uuid ntdll)
endif()

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `clang_slice`: Clang's preprocessor and lexer, and what they need of LLVM, as static archives named by path. Never Clang's
# own CMake targets: their link interface is the shared libLLVM, which costs 17 ms at every start.

set(CLIPC_LLVM 19 CACHE STRING "the LLVM to build with: 19 or 22")
set(CLIPC_LLVM_PREFIX "" CACHE PATH "where that LLVM is installed, if not in Debian's place")
if(NOT CLIPC_LLVM_PREFIX)
  set(CLIPC_LLVM_PREFIX /usr/lib/llvm-${CLIPC_LLVM})
endif()

if(NOT EXISTS ${CLIPC_LLVM_PREFIX}/include/clang/Lex/Preprocessor.h OR NOT EXISTS ${CLIPC_LLVM_PREFIX}/lib/libclangLex.a)
  message(FATAL_ERROR "no Clang libraries in ${CLIPC_LLVM_PREFIX}; "
    "on Debian: apt-get install libclang-${CLIPC_LLVM}-dev llvm-${CLIPC_LLVM}-dev")
endif()

find_package(Threads REQUIRED)
add_library(clang_slice INTERFACE)
target_include_directories(clang_slice SYSTEM INTERFACE ${CLIPC_LLVM_PREFIX}/include)
foreach(archive clangFrontend clangEdit clangLex clangBasic LLVMTargetParser LLVMSupport LLVMDemangle)
  target_link_libraries(clang_slice INTERFACE ${CLIPC_LLVM_PREFIX}/lib/lib${archive}.a)
endforeach()
target_link_libraries(clang_slice INTERFACE Threads::Threads)

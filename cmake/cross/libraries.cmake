# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# For WebAssembly and for Windows: `clang_slice`, `glslang_slice` and `spirv_listing`, which a native build takes
# from installed archives, compiled from Debian's sources, and the header-only libraries. What is compiled is kept by ccache, by content.
# CLIPC_SOURCES is where cmake/cross/fetch_sources.sh has unpacked the sources. With CLIPC_COMPILE_ONLY, which takes half a minute,
# nobody needs them: clipc's own sources are compiled with the headers of LLVM and glslang, and no program is linked.
option(CLIPC_COMPILE_ONLY "compile clipc's own sources, and link nothing" OFF)
set(CLIPC_SOURCES ${clipc_SOURCE_DIR}/build/sources CACHE PATH "where cmake/cross/fetch_sources.sh has unpacked LLVM and glslang")
set(LLVM_SOURCE ${CLIPC_SOURCES}/llvm-toolchain-19)
set(CLIPC_LLVM 19)
set(CLIPC_LLVM_PREFIX /usr/lib/llvm-19)  # its headers are for any system
set(GLSLANG_SOURCE ${CLIPC_SOURCES}/glslang)
set(SPIRV_TOOLS_SOURCE ${CLIPC_SOURCES}/spirv-tools)
if(NOT CLIPC_WASM)
  find_package(Threads REQUIRED)
endif()

if(CLIPC_COMPILE_ONLY)
  set(CMAKE_CXX_FLAGS_RELEASE "-O0 -DNDEBUG")
  foreach(library clang_slice glslang_slice spirv_listing)
    add_library(${library} INTERFACE)
  endforeach()
  target_include_directories(clang_slice SYSTEM INTERFACE ${CLIPC_LLVM_CONFIG} ${CLIPC_LLVM_PREFIX}/include)
  foreach(rule LINK_EXECUTABLE CREATE_SHARED_LIBRARY ARCHIVE_CREATE)
    set(CMAKE_C_${rule} "${CMAKE_COMMAND} -E touch <TARGET>")
    set(CMAKE_CXX_${rule} "${CMAKE_COMMAND} -E touch <TARGET>")
  endforeach()
  set(CMAKE_C_ARCHIVE_FINISH "")
  set(CMAKE_CXX_ARCHIVE_FINISH "")
else()
  include(${CMAKE_CURRENT_LIST_DIR}/compiled.cmake)
endif()

# ---- header-only libraries

add_library(fmt::fmt-header-only INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(spirv_headers INTERFACE)
# Clang for WebAssembly looks among this system's headers by itself. Elsewhere a folder has those that are for any system.
if(NOT CLIPC_WASM)
  set(any_system ${CMAKE_BINARY_DIR}/any_system)
  file(MAKE_DIRECTORY ${any_system})
  foreach(folder fmt nlohmann glslang spirv spirv-tools gtest gmock)
    file(CREATE_LINK /usr/include/${folder} ${any_system}/${folder} SYMBOLIC)
  endforeach()
  foreach(library fmt::fmt-header-only nlohmann_json::nlohmann_json spirv_headers)
    target_include_directories(${library} SYSTEM INTERFACE ${any_system})
  endforeach()
  target_include_directories(glslang_slice SYSTEM INTERFACE ${any_system})
  if(NOT CLIPC_COMPILE_ONLY)
    target_include_directories(glslang_slice SYSTEM PRIVATE ${any_system})
  endif()
  target_link_libraries(clang_slice INTERFACE Threads::Threads ole32 uuid ntdll)
endif()

# ---- GoogleTest, as Debian's package googletest has it

if(BUILD_TESTING)
  set(googletest /usr/src/googletest CACHE PATH "GoogleTest's sources")
  add_library(googletest STATIC ${googletest}/googletest/src/gtest-all.cc ${googletest}/googlemock/src/gmock-all.cc
    ${googletest}/googlemock/src/gmock_main.cc)
  set_target_properties(googletest PROPERTIES UNITY_BUILD OFF)
  target_compile_options(googletest PRIVATE -w)
  target_include_directories(googletest PRIVATE ${googletest}/googletest ${googletest}/googlemock)
  target_include_directories(googletest SYSTEM PUBLIC ${any_system})
  target_link_libraries(googletest PUBLIC Threads::Threads)
  add_library(GTest::gmock ALIAS googletest)
  add_library(GTest::gtest_main ALIAS googletest)
endif()

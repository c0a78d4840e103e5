# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# One folder, one static library, one GoogleTest binary. Sources are found, not listed: a new .cpp or *_test.cpp needs no edit.

include(CheckLinkerFlag)

include(ClipcFmt)
if(NOT CLIPC_FROM_SOURCES)
  find_package(nlohmann_json REQUIRED)
endif()
if(BUILD_TESTING AND NOT CLIPC_FROM_SOURCES)  # or cmake/cross/libraries.cmake has it
  find_package(GTest REQUIRED)
endif()
include(GoogleTest)
set(CLIPC_UNIT_TESTS "" CACHE STRING "the folders whose unit tests are built; all, if that is empty")

# A folder may be empty while it is being written; a library needs one source.
set(CLIPC_EMPTY_SOURCE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
file(CONFIGURE OUTPUT ${CLIPC_EMPTY_SOURCE} CONTENT "")

set(CLIPC_SANITIZER_SOURCE)
if(CLIPC_SANITIZE MATCHES "address")
  set(CLIPC_SANITIZER_SOURCE ${CMAKE_CURRENT_LIST_DIR}/sanitizer_options.cpp)
endif()

# clipc_unite(TARGET): a unity build compiles the files of a folder as one unit, so that the files whose unnamed namespaces are one
# are the same in every such build. The files that name enumerators of ir/intrinsics.def are a unit of their own, so that a new row
# compiles no others. A file with the property SKIP_UNITY_BUILD_INCLUSION is compiled by itself.
function(clipc_unite target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)  # takes a .cpp file in it for a header
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    get_filename_component(file ${source} ABSOLUTE)
    if(EXISTS ${file})  # a generated one may not be there yet
      file(STRINGS ${file} list_of_intrinsics REGEX "^#include \"ir/intrinsic_list.h\"")
      if(list_of_intrinsics)
        string(APPEND folder "_intrinsics")
      endif()
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}")
  endforeach()
endfunction()

# clipc_folder(NAME [PUBLIC libraries that its headers need] [PRIVATE libraries that only its .cpp files need])
# makes library clipc_NAME of every .cpp file in and below the current folder except *_test.cpp and main.cpp,
# and clipc_NAME_test of every *_test.cpp file. A sub-folder with a CMakeLists.txt of its own is left to it.
function(clipc_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 folder "" "" "PUBLIC;PRIVATE")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB_RECURSE nested CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt)
  foreach(file IN LISTS nested)
    cmake_path(GET file PARENT_PATH directory)
    list(FILTER sources EXCLUDE REGEX "^${directory}/")
  endforeach()
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "(_test|/main)\\.cpp$")

  add_library(clipc_${name} STATIC ${sources})
  if(NOT sources)
    target_sources(clipc_${name} PRIVATE ${CLIPC_EMPTY_SOURCE})
  endif()
  clipc_unite(clipc_${name})
  target_include_directories(clipc_${name} PUBLIC $<BUILD_INTERFACE:${clipc_SOURCE_DIR}> $<INSTALL_INTERFACE:include>)
  target_link_libraries(clipc_${name} PUBLIC ${folder_PUBLIC} PRIVATE ${folder_PRIVATE})

  if(BUILD_TESTING AND tests AND (NOT CLIPC_UNIT_TESTS OR name IN_LIST CLIPC_UNIT_TESTS))
    clipc_test(clipc_${name}_test SOURCES ${tests} LIBRARIES clipc_${name} ${folder_PRIVATE} NAME ${name})
  endif()
endfunction()

# clipc_test(TARGET SOURCES ... LIBRARIES ... NAME prefix): a GoogleTest binary; each of its tests is a CTest entry prefix.Suite.Test.
# A binary for another system is one entry, prefix: it starts slowly here.
function(clipc_test target)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "NAME" "SOURCES;LIBRARIES")
  add_executable(${target} ${test_SOURCES} ${CLIPC_SANITIZER_SOURCE})
  clipc_unite(${target})
  target_link_libraries(${target} PRIVATE ${test_LIBRARIES} GTest::gmock GTest::gtest_main)
  # A test's own code runs for milliseconds, and takes twice as long to compile where it is optimized.
  target_compile_options(${target} PRIVATE -O0)
  if(CMAKE_CROSSCOMPILING)
    add_test(NAME ${test_NAME} COMMAND ${target} WORKING_DIRECTORY ${clipc_SOURCE_DIR})
    set_tests_properties(${test_NAME} PROPERTIES FIXTURES_REQUIRED wine TIMEOUT 300)
    return()
  endif()
  gtest_discover_tests(${target}
    TEST_PREFIX ${test_NAME}.
    WORKING_DIRECTORY ${clipc_SOURCE_DIR}
    DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 300)
endfunction()

# clipc_executable(TARGET SOURCES ... LIBRARIES ...): a program that users start, fully static in a release build.
function(clipc_executable target)
  cmake_parse_arguments(PARSE_ARGV 1 program "" "" "SOURCES;LIBRARIES")
  add_executable(${target} ${program_SOURCES} ${CLIPC_SANITIZER_SOURCE})
  target_link_libraries(${target} PRIVATE ${program_LIBRARIES})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CLIPC_BIN})
  if(CLIPC_STATIC AND CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT CLIPC_SANITIZE AND NOT CLIPC_FUZZ)
    target_link_options(${target} PRIVATE -static)
    # The linker warns of getpwnam in LLVM's expansion of `~`, which clipc never asks for.
    check_linker_flag(CXX LINKER:--no-warnings CLIPC_LINKER_IS_QUIET)
    if(CLIPC_LINKER_IS_QUIET)
      target_link_options(${target} PRIVATE LINKER:--no-warnings)
    endif()
    clipc_link_in_order(${target})
  endif()
endfunction()

# clipc_link_in_order(TARGET): links by CLIPC_LINK_ORDER. A program reads from its file what it runs, 64 kB at a time, so that
# functions that lie apart cost a short run more than their instructions do.
function(clipc_link_in_order target)
  if(NOT CLIPC_LINK_ORDER)
    return()
  endif()
  find_program(CLIPC_LLD ld.lld HINTS /usr/lib/llvm-${CLIPC_LLVM}/bin REQUIRED)
  get_filename_component(folder "${CLIPC_LLD}" DIRECTORY)
  target_link_options(${target} PRIVATE -fuse-ld=lld "-B${folder}" "LINKER:--symbol-ordering-file=${CLIPC_LINK_ORDER}"
    LINKER:--no-warn-symbol-ordering)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${CLIPC_LINK_ORDER}")
endfunction()

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Windows programs as a part of a build on Linux, for tests: compiled by mingw-w64, started under Wine. Sets CLIPC_WINDOWS when
# all that it takes is there: mingw-w64's g++, Wine with its server, and Xvfb.
find_program(CLIPC_MINGW NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++)
find_program(CLIPC_WINE NAMES wine64 wine HINTS /usr/lib/wine)
find_program(CLIPC_WINESERVER NAMES wineserver64 wineserver HINTS /usr/lib/wine)
find_program(CLIPC_XVFB NAMES Xvfb)
set(CLIPC_WINDOWS OFF)
if(CLIPC_MINGW AND CLIPC_WINE AND CLIPC_WINESERVER AND CLIPC_XVFB)
  set(CLIPC_WINDOWS ON)
endif()

# clipc_windows_program(TARGET SOURCES ... LIBRARIES ... INCLUDES folders DEPENDS files): makes TARGET.exe, which needs no other
# file of ours, in the current binary folder; its path is the target's property CLIPC_PROGRAM. Sources are relative to the
# repository's root.
function(clipc_windows_program target)
  cmake_parse_arguments(PARSE_ARGV 1 program "" "" "SOURCES;LIBRARIES;INCLUDES;DEPENDS")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_windows)
  # A folder of headers that this system's own are not in.
  get_target_property(json nlohmann_json::nlohmann_json INTERFACE_INCLUDE_DIRECTORIES)
  list(GET json 0 json)
  file(MAKE_DIRECTORY ${folder}/include)
  file(CREATE_LINK ${json}/nlohmann ${folder}/include/nlohmann COPY_ON_ERROR SYMBOLIC)
  set(options -std=c++20 -O2 -Wall -Wextra -ffp-contract=off -fno-tree-slp-vectorize
    -I${clipc_SOURCE_DIR} -isystem ${folder}/include)
  foreach(include IN LISTS program_INCLUDES)
    list(APPEND options -I${include})
  endforeach()
  if(CLIPC_WERROR)
    list(APPEND options -Werror)
  endif()
  set(objects)
  foreach(source IN LISTS program_SOURCES)
    string(REPLACE / _ name ${source})
    set(object ${folder}/${name}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${CLIPC_MINGW} ${options} -MD -MF ${object}.d -c ${clipc_SOURCE_DIR}/${source} -o ${object}
      DEPENDS ${clipc_SOURCE_DIR}/${source} ${program_DEPENDS}
      DEPFILE ${object}.d
      COMMENT "Building Windows object ${source}"
      VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  set(program ${CMAKE_CURRENT_BINARY_DIR}/${target}.exe)
  list(TRANSFORM program_LIBRARIES PREPEND -l)
  add_custom_command(OUTPUT ${program}
    COMMAND ${CLIPC_MINGW} -static -o ${program} ${objects} ${program_LIBRARIES}
    DEPENDS ${objects}
    COMMENT "Linking Windows program ${target}.exe"
    VERBATIM)
  add_custom_target(${target} ALL DEPENDS ${program})
  set_target_properties(${target} PROPERTIES CLIPC_PROGRAM ${program})
endfunction()

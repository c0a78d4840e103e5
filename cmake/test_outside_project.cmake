# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Installs clipc, builds cmake/outside_project with it, and builds it again after a file that its shader includes has changed.
# Then cmake/outside_c_project, and the same program by pkg-config; and no name but those of clipc.h leaves the libraries.
#   cmake -DBUILD= -DSCRATCH= -DGENERATOR= -DCOMPILER= -DC_COMPILER= -DNM= -P test_outside_project.cmake
function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${status}\n${output}")
  endif()
  set(output ${output} PARENT_SCOPE)
endfunction()

function(expect text)
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "expected `${text}`, got `${output}`")
  endif()
endfunction()

set(project ${SCRATCH}/project)
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/outside_project/ DESTINATION ${project})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed)
run(${CMAKE_COMMAND} -S ${project} -B ${SCRATCH}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${SCRATCH}/installed
  -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/outside)
expect("second plane: byte 16 of b3")

run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
if(output MATCHES "Compiling shader")
  message(FATAL_ERROR "shaders are compiled again though nothing has changed:\n${output}")
endif()

file(READ ${project}/planes.hlsli text)
string(REPLACE "float4 second" "float4 between;\n  float4 second" text "${text}")
file(WRITE ${project}/planes.hlsli "${text}")
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/outside)
expect("second plane: byte 32 of b3")

# ---- in C

set(installed ${SCRATCH}/installed)
set(source ${CMAKE_CURRENT_LIST_DIR}/outside_c_project)
run(${CMAKE_COMMAND} -S ${source} -B ${SCRATCH}/c_build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${installed}
  -DCMAKE_C_COMPILER=${C_COMPILER})
run(${CMAKE_COMMAND} --build ${SCRATCH}/c_build)
file(GLOB programs ${SCRATCH}/c_build/embed_*)
foreach(program IN LISTS programs)
  run(${program})
  expect("plane water: byte 16 of b3, lowering 0")
endforeach()

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  set(ENV{PKG_CONFIG_PATH} ${installed}/lib/pkgconfig)
  run(${PKG_CONFIG} --cflags --libs clipc clipc-runtime)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${C_COMPILER} -std=c99 ${source}/main.c -o ${SCRATCH}/by_pkg_config ${flags} -Wl,-rpath,${installed}/lib)
  run(${SCRATCH}/by_pkg_config)
  expect("plane water: byte 16 of b3, lowering 0")
endif()

# The names in exports.map are all that leaves the libraries.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../compiler/library/exports.map lines)
string(REGEX MATCHALL "clipc_[a-z_]+" functions "${lines}")
list(SORT functions)
foreach(arguments "-D;--defined-only;${installed}/lib/libclipc.so" "-g;--defined-only;${installed}/lib/libclipc.a")
  list(GET arguments 2 library)
  if(NOT EXISTS ${library})
    continue()
  endif()
  run(${NM} --format=posix ${arguments})
  # Not type `u`: constants in Debian's archives that no tool makes local, and that are the same wherever they come from.
  string(REGEX MATCHALL "[^\n ]+ [A-Z]" names "${output}")
  list(TRANSFORM names REPLACE "[@ ].*" "")
  list(FILTER names EXCLUDE REGEX "CLIPC_1")
  list(SORT names)
  if(NOT names STREQUAL functions)
    message(FATAL_ERROR "${library} shows ${names}, not ${functions}")
  endif()
endforeach()
file(REMOVE_RECURSE ${SCRATCH})

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Installs clipc, builds cmake/outside_project with it, and builds it again after a file that its shader includes has changed.
#   cmake -DBUILD= -DSCRATCH= -DGENERATOR= -DCOMPILER= -P test_outside_project.cmake
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
file(REMOVE_RECURSE ${SCRATCH})

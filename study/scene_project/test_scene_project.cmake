# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Has a scene's shaders listed, builds the project beside this with that list, and looks for exactly these shaders.
#   cmake -DSTUDY= -DPACKAGE= -DSCENE= -DCOSTS= -DSCRATCH= -DGENERATOR= -DCOMPILER= -DWANTED=name|name -P test_scene_project.cmake
function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${status}\n${output}")
  endif()
  set(output ${output} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
set(list ${SCRATCH}/variants.cmake)
run(${STUDY} scene ${SCENE} --costs ${COSTS} --variants ${list})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
  -DLIST=${list} -Dclipc_DIR=${PACKAGE})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)

set(folder ${SCRATCH}/build/scene_shaders)
file(GLOB found RELATIVE ${folder} ${folder}/*.vert)
list(SORT found)
string(REPLACE "|" ";" wanted "${WANTED}")
if(NOT found STREQUAL wanted)
  message(FATAL_ERROR "expected the shaders `${wanted}`, got `${found}`")
endif()

# object.1.vert writes one distance, object.0.vert none.
foreach(name IN LISTS found)
  string(REGEX MATCH "\\.([0-9])\\.vert$" unused ${name})
  file(STRINGS ${folder}/${name} writes REGEX "^ *gl_ClipDistance\\[[0-9]\\] = ")
  list(LENGTH writes count)
  if(NOT count EQUAL CMAKE_MATCH_1)
    message(FATAL_ERROR "${name} writes ${count} clip distances")
  endif()
endforeach()

# The program has each method's shaders in one array, by number of planes.
run(${SCRATCH}/build/scene)
foreach(name IN LISTS found)
  string(REGEX REPLACE "\\..*" "" method ${name})
  set(files ${found})
  list(FILTER files INCLUDE REGEX "^${method}\\.")
  list(LENGTH files count)
  if(NOT output MATCHES "${method}: ${count} shaders")
    message(FATAL_ERROR "expected ${count} shaders of ${method}, got `${output}`")
  endif()
endforeach()
file(REMOVE_RECURSE ${SCRATCH})

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The laboratory, study/, is a project of its own, which finds this build as a package. The target `study` builds clipc-study of it in
# the folder study/ of this build, and ClipcPackages.cmake packs what is there; a plain build does neither.
if(NOT TARGET clipc_static)
  return()
endif()

# The package: beside clipc-config.cmake, what it includes.
export(EXPORT clipc NAMESPACE clipc:: FILE ${clipc_BINARY_DIR}/clipc-targets.cmake)
foreach(file ClipcShaders.cmake embed_shaders.cmake)
  configure_file(${clipc_SOURCE_DIR}/cmake/${file} ${clipc_BINARY_DIR}/${file} COPYONLY)
endforeach()

set(CLIPC_STUDY ${clipc_BINARY_DIR}/study)
add_custom_command(OUTPUT ${CLIPC_STUDY}/CMakeCache.txt
  COMMAND ${CMAKE_COMMAND} -S ${clipc_SOURCE_DIR}/study -B ${CLIPC_STUDY} -G ${CMAKE_GENERATOR} -Dclipc_DIR=${clipc_BINARY_DIR}
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_UNITY_BUILD=${CMAKE_UNITY_BUILD}
    -DCLIPC_WERROR=${CLIPC_WERROR} -DBUILD_TESTING=${BUILD_TESTING}
  COMMENT "Configuring the laboratory"
  VERBATIM)
add_custom_target(study COMMAND ${CMAKE_COMMAND} --build ${CLIPC_STUDY} --target clipc-study
  DEPENDS ${CLIPC_STUDY}/CMakeCache.txt USES_TERMINAL VERBATIM)
add_dependencies(study clipc clipc_runtime clipc_static)

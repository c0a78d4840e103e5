# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What other projects get: find_package(clipc) with clipc::runtime, clipc::runtime_gl, the compiler and clipc_add_shader().
include(CMakePackageConfigHelpers)

set_target_properties(clipc_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(clipc_runtime_gl PROPERTIES EXPORT_NAME runtime_gl)
set_target_properties(clipc_clip_table PROPERTIES EXPORT_NAME clip_table)
set(targets clipc clipc_runtime clipc_runtime_gl clipc_clip_table)
if(TARGET clipc_runtime_d3d9)
  set_target_properties(clipc_runtime_d3d9 PROPERTIES EXPORT_NAME runtime_d3d9)
  list(APPEND targets clipc_runtime_d3d9)
endif()
install(TARGETS ${targets} EXPORT clipc)
foreach(folder runtime clip-table)
  install(DIRECTORY ${clipc_SOURCE_DIR}/${folder} DESTINATION include/clipc FILES_MATCHING PATTERN *.h
    PATTERN allocation_count.h EXCLUDE PATTERN test_cameras.h EXCLUDE PATTERN test_tables.h EXCLUDE PATTERN json.h EXCLUDE)
endforeach()

set(package lib/cmake/clipc)
install(EXPORT clipc NAMESPACE clipc:: FILE clipc-targets.cmake DESTINATION ${package})
file(CONFIGURE OUTPUT ${clipc_BINARY_DIR}/clipc-config.cmake @ONLY CONTENT
[[# Written by clipc's build.
include(${CMAKE_CURRENT_LIST_DIR}/clipc-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/ClipcShaders.cmake)
]])
write_basic_package_version_file(${clipc_BINARY_DIR}/clipc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${clipc_BINARY_DIR}/clipc-config.cmake ${clipc_BINARY_DIR}/clipc-config-version.cmake
  ${clipc_SOURCE_DIR}/cmake/ClipcShaders.cmake ${clipc_SOURCE_DIR}/cmake/embed_shaders.cmake DESTINATION ${package})

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What other projects get: find_package(clipc) with clipc::runtime, clipc::runtime_gl, clipc::effect_runtime, clipc::compiler,
# clipc::compiler_shared, the program clipc::clipc and clipc_add_shader(); and the same libraries for pkg-config.
include(CMakePackageConfigHelpers)

set_target_properties(clipc_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(clipc_runtime_gl PROPERTIES EXPORT_NAME runtime_gl)
set_target_properties(clipc_effect_runtime PROPERTIES EXPORT_NAME effect_runtime)
set_target_properties(clipc_clip_table PROPERTIES EXPORT_NAME clip_table)
set(targets clipc clipc_runtime clipc_runtime_gl clipc_effect_runtime clipc_clip_table)
foreach(library shared static)
  if(TARGET clipc_${library})
    list(APPEND targets clipc_${library})
  endif()
endforeach()
if(TARGET clipc_runtime_d3d9)
  set_target_properties(clipc_runtime_d3d9 PROPERTIES EXPORT_NAME runtime_d3d9)
  list(APPEND targets clipc_runtime_d3d9)
endif()
install(TARGETS ${targets} EXPORT clipc
  RUNTIME COMPONENT compiler LIBRARY COMPONENT library NAMELINK_COMPONENT development ARCHIVE COMPONENT development)
foreach(folder runtime effect-runtime clip-table)
  install(DIRECTORY ${clipc_SOURCE_DIR}/${folder} DESTINATION include/clipc COMPONENT development FILES_MATCHING PATTERN *.h PATTERN c_interface.h EXCLUDE PATTERN effect_gl.h EXCLUDE
    PATTERN allocation_count.h EXCLUDE PATTERN test_cameras.h EXCLUDE PATTERN test_tables.h EXCLUDE PATTERN json.h EXCLUDE)
endforeach()
install(FILES ${clipc_SOURCE_DIR}/compiler/clipc.h ${clipc_SOURCE_DIR}/compiler/clipc_effect.h ${clipc_SOURCE_DIR}/compiler/clipc.hpp DESTINATION include/clipc
  COMPONENT development)

# Programs of this build, like the examples, write <clipc/runtime/table.h> as others do: links stand where an installation has copies.
set(headers ${clipc_BINARY_DIR}/include/clipc)
file(MAKE_DIRECTORY ${headers})
foreach(header runtime effect-runtime clip-table compiler/clipc.h compiler/clipc_effect.h compiler/clipc.hpp)
  cmake_path(GET header FILENAME name)
  file(CREATE_LINK ${clipc_SOURCE_DIR}/${header} ${headers}/${name} COPY_ON_ERROR SYMBOLIC)
endforeach()
foreach(library IN LISTS targets)
  if(NOT library STREQUAL clipc)
    target_include_directories(${library} INTERFACE $<BUILD_INTERFACE:${clipc_BINARY_DIR}/include>)
  endif()
endforeach()

set(package lib/cmake/clipc)
install(EXPORT clipc NAMESPACE clipc:: FILE clipc-targets.cmake DESTINATION ${package} COMPONENT development)
file(CONFIGURE OUTPUT ${clipc_BINARY_DIR}/clipc-config.cmake @ONLY CONTENT
[[# Written by clipc's build.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/clipc-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/ClipcShaders.cmake)

# clipc's code needs the library of C++, which the linker of a project in C does not add.
get_property(clipc_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT CXX IN_LIST clipc_languages)
  foreach(clipc_target clip_table runtime runtime_gl effect_runtime compiler)
    if(TARGET clipc::${clipc_target})
      set_property(TARGET clipc::${clipc_target} APPEND PROPERTY INTERFACE_LINK_LIBRARIES stdc++ m)
    endif()
  endforeach()
endif()

foreach(clipc_component IN LISTS clipc_FIND_COMPONENTS)
  if(NOT TARGET clipc::${clipc_component} AND clipc_FIND_REQUIRED_${clipc_component})
    set(clipc_FOUND FALSE)
    set(clipc_NOT_FOUND_MESSAGE "this clipc has no clipc::${clipc_component}")
  endif()
endforeach()
]])
write_basic_package_version_file(${clipc_BINARY_DIR}/clipc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${clipc_BINARY_DIR}/clipc-config.cmake ${clipc_BINARY_DIR}/clipc-config-version.cmake
  ${clipc_SOURCE_DIR}/cmake/ClipcShaders.cmake ${clipc_SOURCE_DIR}/cmake/embed_shaders.cmake DESTINATION ${package} COMPONENT development)

# clipc_pkg_config(NAME DESCRIPTION LIBRARIES): a file for pkg-config, which may be moved with what it names.
function(clipc_pkg_config name description libraries)
  file(CONFIGURE OUTPUT ${clipc_BINARY_DIR}/${name}.pc @ONLY CONTENT
[[prefix=${pcfiledir}/../..
Name: @name@
Description: @description@
Version: @clipc_VERSION@
Cflags: -I${prefix}/include
Libs: -L${prefix}/lib @libraries@
Libs.private: -lstdc++ -lm
]])
  install(FILES ${clipc_BINARY_DIR}/${name}.pc DESTINATION lib/pkgconfig COMPONENT development)
endfunction()
clipc_pkg_config(clipc "HLSL to GLSL and SPIR-V, every stage and effects, clip planes kept" "-lclipc")
clipc_pkg_config(clipc-runtime "what draws with the shaders that clipc compiled" "-lclipc_runtime -lclipc_clip_table -lstdc++ -lm")
clipc_pkg_config(clipc-runtime-gl "clipc-runtime on OpenGL"
  "-lclipc_runtime_gl -lclipc_runtime -lclipc_clip_table -lstdc++ -lm")
clipc_pkg_config(clipc-effect-runtime "what draws with the effects that clipc compiled, on OpenGL"
  "-lclipc_effect_runtime -lclipc_runtime_gl -lclipc_runtime -lclipc_clip_table -lstdc++ -lm")

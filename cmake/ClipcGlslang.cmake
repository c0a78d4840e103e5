# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `glslang_slice`: glslang's GLSL parser, for --validate. CMAKE_PREFIX_PATH, or the folder of a package's files for find_package
# (glslang_DIR and the like), says where it is. These files are not loaded: Debian's name programs of a package that need not
# be installed.

set(prefixes)
foreach(folder IN ITEMS ${glslang_DIR} ${SPIRV-Tools_DIR} ${SPIRV-Tools-opt_DIR} ${spirv_cross_core_DIR} ${spirv_cross_glsl_DIR})
  list(APPEND prefixes ${folder}/../../.. ${folder}/../..)
endforeach()

# clipc_find_archive(VARIABLE NAME): a static library.
macro(clipc_find_archive variable name)
  find_library(${variable} NAMES lib${name}.a ${name} HINTS ${prefixes} PATH_SUFFIXES lib)
endmacro()

find_path(GLSLANG_INCLUDE glslang/Public/ShaderLang.h HINTS ${prefixes} PATH_SUFFIXES include)
add_library(glslang_slice INTERFACE)
target_include_directories(glslang_slice SYSTEM INTERFACE ${GLSLANG_INCLUDE})

# In link order. Which of them exist depends on glslang's version: 14 dropped HLSL and OGLCompiler, 16 has one archive.
foreach(archive glslang HLSL MachineIndependent GenericCodeGen OGLCompiler OSDependent glslang-default-resource-limits)
  clipc_find_archive(GLSLANG_${archive} ${archive})
  if(GLSLANG_${archive})
    target_link_libraries(glslang_slice INTERFACE ${GLSLANG_${archive}})
  endif()
endforeach()
if(NOT GLSLANG_INCLUDE OR NOT GLSLANG_glslang)
  message(FATAL_ERROR "no static glslang; CMAKE_PREFIX_PATH says where it is; on Debian: apt-get install glslang-dev")
endif()
if(NOT EXISTS ${GLSLANG_INCLUDE}/glslang/MachineIndependent/localintermediate.h)
  message(FATAL_ERROR "${GLSLANG_INCLUDE} has a glslang without the headers of its tree, which link/glsl.cpp reads; versions 12 and 13 "
    "install them, as Debian 12 does, 14 and later do not; CMAKE_PREFIX_PATH says where another one is")
endif()
target_link_libraries(glslang_slice INTERFACE Threads::Threads)

# `spirv_headers`: SPIR-V's numbers.
find_path(SPIRV_HEADERS_INCLUDE spirv/unified1/spirv.hpp11 HINTS ${prefixes} PATH_SUFFIXES include)
if(NOT SPIRV_HEADERS_INCLUDE)
  message(FATAL_ERROR "no SPIR-V headers; CMAKE_PREFIX_PATH says where they are; on Debian: apt-get install spirv-headers")
endif()
add_library(spirv_headers INTERFACE)
target_include_directories(spirv_headers SYSTEM INTERFACE ${SPIRV_HEADERS_INCLUDE})

# `spirv_listing`: SPIRV-Tools' listing of SPIR-V; not there where its archive is not.
clipc_find_archive(SPIRV_TOOLS SPIRV-Tools)
if(SPIRV_TOOLS)
  add_library(spirv_listing INTERFACE)
  target_include_directories(spirv_listing SYSTEM INTERFACE ${GLSLANG_INCLUDE})
  target_link_libraries(spirv_listing INTERFACE ${SPIRV_TOOLS})
endif()

# `glslang_spirv`: what makes SPIR-V of GLSL, for tools; not there where these archives are not.
clipc_find_archive(GLSLANG_SPIRV SPIRV)
clipc_find_archive(SPIRV_TOOLS_OPT SPIRV-Tools-opt)
if(GLSLANG_SPIRV AND SPIRV_TOOLS_OPT AND SPIRV_TOOLS)
  add_library(glslang_spirv INTERFACE)
  target_link_libraries(glslang_spirv INTERFACE ${GLSLANG_SPIRV} glslang_slice ${SPIRV_TOOLS_OPT} ${SPIRV_TOOLS})
endif()
clipc_find_archive(SPIRV_CROSS_GLSL spirv-cross-glsl)
clipc_find_archive(SPIRV_CROSS_CORE spirv-cross-core)

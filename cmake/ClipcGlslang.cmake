# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `glslang_slice`: glslang's GLSL parser, for --validate.

find_path(GLSLANG_INCLUDE glslang/Public/ShaderLang.h)
add_library(glslang_slice INTERFACE)
target_include_directories(glslang_slice SYSTEM INTERFACE ${GLSLANG_INCLUDE})

# In link order. Which of them exist depends on glslang's version: 14 dropped HLSL and OGLCompiler, 16 has one archive.
foreach(archive glslang HLSL MachineIndependent GenericCodeGen OGLCompiler OSDependent glslang-default-resource-limits)
  find_library(GLSLANG_${archive} lib${archive}.a)
  if(GLSLANG_${archive})
    target_link_libraries(glslang_slice INTERFACE ${GLSLANG_${archive}})
  endif()
endforeach()
if(NOT GLSLANG_INCLUDE OR NOT GLSLANG_glslang)
  message(FATAL_ERROR "no static glslang; on Debian: apt-get install glslang-dev")
endif()
target_link_libraries(glslang_slice INTERFACE Threads::Threads)

# `glslang_spirv`: what makes SPIR-V of it; not there where these archives are not.
find_library(GLSLANG_SPIRV libSPIRV.a)
find_library(SPIRV_TOOLS_OPT libSPIRV-Tools-opt.a)
find_library(SPIRV_TOOLS libSPIRV-Tools.a)
if(GLSLANG_SPIRV AND SPIRV_TOOLS_OPT AND SPIRV_TOOLS)
  add_library(glslang_spirv INTERFACE)
  target_link_libraries(glslang_spirv INTERFACE ${GLSLANG_SPIRV} glslang_slice ${SPIRV_TOOLS_OPT} ${SPIRV_TOOLS})
endif()
find_library(SPIRV_CROSS_GLSL libspirv-cross-glsl.a)
find_library(SPIRV_CROSS_CORE libspirv-cross-core.a)

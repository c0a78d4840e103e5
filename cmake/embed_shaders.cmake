# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes HEADER with GLSL as constants of C and C++; clipc_add_shader() runs it at build time.
#   cmake -DNAME= -DSTAGE=vert -DGLSL=file|file -DFRAGMENT=file|file -DVARIANTS= -DTABLE=file.clip.h -DSPIRV= -DHEADER= -P embed_shaders.cmake

set(out "// Written by clipc_add_shader(); changes are lost.
#pragma once
#ifndef CLIPC_SHADER
#ifdef __cplusplus
#define CLIPC_SHADER inline constexpr
#else
#define CLIPC_SHADER static
#endif
#endif
#if defined(__GNUC__) && !defined(__cplusplus)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored \"-Woverlength-strings\"
#endif
")

# The clip table says how many variants there are; files may be left from when the shader had more planes.
if(NOT VARIANTS STREQUAL "")
  file(STRINGS ${TABLE} table REGEX "^ +[0-9]+u, [0-9]u,$")  # enable_mask, plane_count
  string(REGEX REPLACE ".*, ([0-9])u,$" "\\1" planes "${table}")
  if(VARIANTS GREATER planes)
    message(FATAL_ERROR "VARIANTS ${VARIANTS}: shader `${NAME}` has ${planes} clip plane(s); take no more")
  endif()
endif()

# The files as a text NAME, or with VARIANTS as an array of them by the number of clip planes. Each line is a literal of its own, since
# compilers limit their length.
function(add_constant name files)
  string(REPLACE "|" ";" files "${files}")
  set(literals)
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(REPLACE "\\" "\\\\" text "${text}")
    string(REPLACE "\"" "\\\"" text "${text}")
    string(REPLACE "\n" "\\n\"\n    \"" text "${text}")
    string(APPEND literals "    \"${text}\",\n")
  endforeach()
  if(VARIANTS STREQUAL "")
    string(REGEX REPLACE ",\n$" ";\n" literals "${literals}")
    string(APPEND out "\nCLIPC_SHADER const char ${name}[] =\n${literals}")
  else()
    string(APPEND out "\n// ${name}[n] is for n clip planes.\nCLIPC_SHADER const char* const ${name}[] = {\n${literals}};\n")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

add_constant(${NAME}_${STAGE} "${GLSL}")
if(FRAGMENT)
  add_constant(${NAME}_frag "${FRAGMENT}")
endif()
if(SPIRV)
  # That file may be included by itself too.
  cmake_path(REPLACE_FILENAME HEADER ${NAME}.spv.h OUTPUT_VARIABLE words)
  file(READ ${words} text)
  file(WRITE ${words} "#pragma once\n${text}")
  string(APPEND out "\n#include \"${NAME}.spv.h\"\n")
endif()
string(APPEND out "
#if defined(__GNUC__) && !defined(__cplusplus)
#pragma GCC diagnostic pop
#endif
")
file(WRITE ${HEADER} "${out}")

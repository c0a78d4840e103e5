# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes HEADER with GLSL as C++ constants; clipc_add_shader() runs it at build time.
#   cmake -DNAME= -DSTAGE=vert -DGLSL=file|file -DFRAGMENT=file|file -DVARIANTS= -DTABLE=file.clip.h -DSPIRV= -DHEADER= -P embed_shaders.cmake

set(out "// Written by clipc_add_shader(); changes are lost.\n#pragma once\n")

# The clip table says how many variants there are; files may be left from when the shader had more planes.
if(NOT VARIANTS STREQUAL "")
  file(STRINGS ${TABLE} table REGEX "^ +[0-9]+u, [0-9]u,$")  # enable_mask, plane_count
  string(REGEX REPLACE ".*, ([0-9])u,$" "\\1" planes "${table}")
  if(VARIANTS GREATER planes)
    message(FATAL_ERROR "VARIANTS ${VARIANTS}: shader `${NAME}` has ${planes} clip plane(s); take no more")
  endif()
endif()

# The files as a raw string literal NAME, or with VARIANTS as an array of them by the number of clip planes.
function(add_constant name files)
  string(REPLACE "|" ";" files "${files}")
  set(literals)
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(APPEND literals "R\"clipc(${text})clipc\",\n")
  endforeach()
  if(VARIANTS STREQUAL "")
    string(REGEX REPLACE ",\n$" ";\n" literals "${literals}")
    string(APPEND out "\ninline constexpr char ${name}[] = ${literals}")
  else()
    string(APPEND out "\n// ${name}[n] is for n clip planes.\ninline constexpr const char* ${name}[] = {\n${literals}};\n")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

add_constant(${NAME}_${STAGE} "${GLSL}")
if(FRAGMENT)
  add_constant(${NAME}_frag "${FRAGMENT}")
endif()
if(SPIRV)
  string(APPEND out "\n#include \"${NAME}.spv.h\"\n")
endif()
file(WRITE ${HEADER} "${out}")

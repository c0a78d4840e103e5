# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes HEADER with GLSL as C++ constants; clipc_add_shader() runs it at build time.
#   cmake -DNAME= -DVERTEX=file|file -DFRAGMENT=file -DVARIANTS= -DHEADER= -P embed_shaders.cmake

# literal(VARIABLE FILE): the file as a raw string literal.
function(literal variable file)
  file(READ ${file} text)
  set(${variable} "R\"clipc(${text})clipc\"" PARENT_SCOPE)
endfunction()

set(out "// Written by clipc_add_shader(); changes are lost.\n#pragma once\n\n")
string(REPLACE "|" ";" VERTEX "${VERTEX}")
if(VARIANTS STREQUAL "")
  literal(text ${VERTEX})
  string(APPEND out "inline constexpr char ${NAME}_vert[] = ${text};\n")
else()
  string(APPEND out "// ${NAME}_vert[n] is the shader with n clip planes.\ninline constexpr const char* ${NAME}_vert[] = {\n")
  foreach(file IN LISTS VERTEX)
    literal(text ${file})
    string(APPEND out "${text},\n")
  endforeach()
  string(APPEND out "};\n")
endif()
if(FRAGMENT)
  literal(text ${FRAGMENT})
  string(APPEND out "\ninline constexpr char ${NAME}_frag[] = ${text};\n")
endif()
file(WRITE ${HEADER} "${out}")

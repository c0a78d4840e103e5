# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes the manual page: the template with the options of `clipc --help`.
#   cmake -DCLIPC=program -DVERSION= -DTEMPLATE=clipc.1.in -DOUTPUT=clipc.1 -P make_manual.cmake
execute_process(COMMAND ${CLIPC} --help OUTPUT_VARIABLE help RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${CLIPC} --help: ${status}")
endif()

# roff takes these for its own: backslashes, hyphens, and a dot or quote at the start of a line.
string(REPLACE "\\" "\\e" help "${help}")
string(REPLACE "-" "\\-" help "${help}")
string(REPLACE ";" "<semicolon>" help "${help}")  # which separates a list's elements
string(REPLACE "[" "\\(lB" help "${help}")
string(REPLACE "]" "\\(rB" help "${help}")
string(REPLACE "\n" ";" lines "${help}")
set(OPTIONS "")
foreach(line IN LISTS lines)
  if(line MATCHES "^  ([^ ]+( <[^>]*>)?)(  +(.*))?$")  # `  -T <PROFILE>     what it is`, or the description below
    string(APPEND OPTIONS ".TP\n.B ${CMAKE_MATCH_1}\n")
    if(CMAKE_MATCH_4)
      string(APPEND OPTIONS "\\&${CMAKE_MATCH_4}\n")
    endif()
  elseif(line MATCHES "^[a-z]+: (.+)$")  # the title of a topic
    string(APPEND OPTIONS ".SS ${CMAKE_MATCH_1}\n")
  elseif(line MATCHES "^      +(.+)$")
    string(APPEND OPTIONS "\\&${CMAKE_MATCH_1}\n")
  endif()
endforeach()
string(STRIP "${OPTIONS}" OPTIONS)
string(REPLACE "<semicolon>" ";" OPTIONS "${OPTIONS}")
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)

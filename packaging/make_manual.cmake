# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes the manual page: the template with the options of `clipc --help` and of `clipc --help=compilers`.
#   cmake -DCLIPC=program -DVERSION= -DTEMPLATE=clipc.1.in -DOUTPUT=clipc.1 -P make_manual.cmake
execute_process(COMMAND ${CLIPC} --help OUTPUT_VARIABLE help RESULT_VARIABLE status)
execute_process(COMMAND ${CLIPC} --help=compilers OUTPUT_VARIABLE compilers RESULT_VARIABLE status_of_topic)
if(NOT status EQUAL 0 OR NOT status_of_topic EQUAL 0)
  message(FATAL_ERROR "${CLIPC} --help: ${status}, ${status_of_topic}")
endif()
string(REGEX REPLACE "\n  -" "\n      -" compilers "${compilers}")  # text, not options that a description follows
string(APPEND help "\n${compilers}")

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

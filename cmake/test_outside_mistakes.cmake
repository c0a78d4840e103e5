# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The messages of clipc_add_shader() and clipc_add_hlsl_pass() about mistakes: builds cmake/outside_mistakes with each CASE.
#   cmake -DCLIPC= -DSCRATCH= -DGENERATOR= -DCOMPILER= -P test_outside_mistakes.cmake
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/outside_mistakes/ DESTINATION ${SCRATCH}/project)
set(project ${SCRATCH}/project)
set(plane "cbuffer Clip { float4 first, second; };\n")
set(body "float4 main(float4 position : POSITION) : SV_Position { return position; }\n")
file(WRITE ${project}/empty.cpp "")
file(WRITE ${project}/two_planes.hlsl "${plane}[clipplanes(first, second)] ${body}")
file(WRITE ${project}/warns.hlsl "${plane}[clipplanes(first, first)] ${body}")

file(WRITE ${project}/sky.fx "#include \"sky.fxh\"\nfloat4 VS(float4 p : POSITION) : POSITION { return p * SKY * BLUE; }\n"
  "technique T { pass P { VertexShader = compile vs_3_0 VS(); } }\n")
file(WRITE ${project}/sky.fxh "#define SKY 2.5\n")

# expect(CASE STATUS TEXT): configures and builds; the exit code is zero (STATUS `passes`) or not, and TEXT is said once.
function(expect case status text)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${project} -B ${SCRATCH}/build -G ${GENERATOR} -DCASE=${case}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_MODULE_PATH=${CMAKE_CURRENT_LIST_DIR} -DCLIPC_EXECUTABLE=${CLIPC}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
  if(result EQUAL 0)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build OUTPUT_VARIABLE built ERROR_VARIABLE built RESULT_VARIABLE result)
    string(APPEND said "${built}")
  endif()
  if(result EQUAL 0 AND NOT status STREQUAL "passes" OR NOT result EQUAL 0 AND status STREQUAL "passes")
    message(FATAL_ERROR "${case}: exit code ${result}, expected that it ${status}\n${said}")
  endif()
  string(REGEX REPLACE "[ \n]+" " " line "${said}")
  string(LENGTH "${text}" length)
  string(FIND "${line}" "${text}" first)
  string(FIND "${line}" "${text}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${case}: expected `${text}` once, got\n${said}")
  endif()
endfunction()

expect(old_cmake fails "clipc_add_shader needs CMake 3.20 or later")
expect(name fails "`my-shader` cannot name a constant; give another NAME")
expect(one_stem fails "the target has a shader `two_planes` already; give another NAME")
expect(unknown_argument fails "what is `PROFIL;vs_5_0`? It has SHADER, NAME")
expect(not_a_number fails "VARIANTS many is not a number of planes, 0 to 6")
expect(effect_unknown fails "what is `TARGETS;glsl330`? It has EFFECT, NAME, TARGET, DEFINES and OPTIONS")
expect(effect_stem fails "the target has an effect `sky` already; give another NAME")
expect(no_shader fails "clipc_add_shader(shaders SHADER file ...): SHADER is missing")
expect(pass_unknown fails "what is `SHADER;two_planes.hlsl`? It has PROFILE, FILES, ENTRIES, DEFINES, INCLUDES, OPTIONS and THEN")
expect(pass_then fails "the command has no `{hlsl}`; it reads {hlsl} and writes {output} with an extension")
expect(pass_output fails "the command has no `{output}`; it reads {hlsl} and writes {output} with an extension")
expect(pass_stem fails "the target has a file `two_planes` already; give it another target")
expect(pass_entry fails "[entry-not-found, X3501]")
expect(warning passes "[-Wclip-plane-repeated]")
expect(cross passes "Compiling shader two_planes")

# A shader that loses a plane: the variant of before does not count.
expect(planes passes "Compiling shader two_planes")
file(WRITE ${project}/two_planes.hlsl "${plane}[clipplanes(first)] ${body}")
expect(planes_fewer fails "VARIANTS 2: shader `two_planes` has 1 clip plane(s); take no more")

# An effect is compiled again where a file that it includes has changed.
foreach(sky IN ITEMS 2.5 7.5)
  file(WRITE ${project}/sky.fxh "#define SKY ${sky}\n")
  expect(effect passes "Compiling effect heaven")
  file(GLOB_RECURSE header ${SCRATCH}/build/heaven.effect.h)
  file(READ "${header}" text)
  string(FIND "${text}" "${sky}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "the header of the effect does not have ${sky}:\n${text}")
  endif()
endforeach()
file(REMOVE_RECURSE ${SCRATCH})

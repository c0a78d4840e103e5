# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Shaders as a part of a build:
#
#   clipc_add_shader(TARGET SHADER water.hlsl
#     [NAME water]               # of what is written; the shader's file name without its extension
#     [ENTRY main] [PROFILE vs_5_0]   # or gs_5_0: NAME.geom; or ps_5_0, cs_5_0: NAME.frag or NAME.comp, without a clip table
#     [LOWER clip-distance|level9|near-plane|discard|none]
#     [TARGET glsl450]           # the GLSL to write
#     [FRAGMENT water.frag]      # with LOWER discard: the fragment shader that gets the discard
#     [PIXEL_SHADER water.ps.hlsl [PIXEL_ENTRY main]]  # the pixel shader that it must fit
#     [PAIR]                     # write the pixel shader too; PIXEL_ENTRY without PIXEL_SHADER, of the same file, asks for that
#     [TABLE .h|.json|.bin]      # the clip table, beside the header below; .h without this
#     [REFLECT [json] [h]]       # the reflection too: NAME.reflect.json, without a word or for json; NAME.reflect.h, structs for C and C++
#     [STRUCT_PREFIX Gpu]        # with REFLECT h: what the names of these structs begin with
#     [SPIRV]                    # NAME.spv and NAME.spv.h too; the GLSL is Vulkan's unless TARGET is another, then it is SPIR-V for OpenGL
#     [VARIANTS n]               # one shader for each number of planes from 0 to n, which is no more than the shader has
#     [DEFINES A B=1] [OPTIONS --flip-y ...])
#
# compiles the shader with clipc whenever it or a file that it includes has changed. The target gets an include folder with
# NAME.shader.h (const char NAME_vert[], with VARIANTS const char* const NAME_vert[n + 1], and likewise NAME_frag with FRAGMENT and of a
# pair; with SPIRV uint32_t NAME_spv[], of a pair also NAME_spv_pixel[]; with VARIANTS too these are arrays of pointers, beside which
# NAME_spv_sizes[] has the bytes of each) and NAME.clip.h (constexpr clipc::StaticClipTable
# NAME_clip_table, or in C the same table as JSON, const char NAME_clip_table[], for clipc_table_read). Both are C99 and C++17. The target
# property CLIPC_SHADER_FOLDER names that folder, where NAME.vert and the table in other forms lie too.
#
#   clipc_add_hlsl_pass(TARGET FILES water.hlsl...
#     [ENTRIES main] [PROFILE vs_5_0]
#     [DEFINES A B=1] [INCLUDES folder...] [OPTIONS --plane-space=xyw1 ...]
#     [THEN glslangValidator -D -V -S vert -e main {defines} {includes} {hlsl} -o {output}.spv])
#
# writes each file with its clip planes as clip distances, for a compiler of HLSL that drops the planes, and gives it to that compiler:
# THEN. In its words `{hlsl}` is the file that clipc wrote, and `{output}` a file's name without an extension, after which THEN puts one:
# it writes one file or several, which the target then has. `{defines}` and `{includes}`, words of their own, are -D and -I of DEFINES, of
# INCLUDES and of the shader's folder. Both commands run whenever the file or one that it includes has changed. The target may be a
# custom target; the property CLIPC_HLSL_FOLDER names the folder of what is written, which is an include folder of any other target.
#
#   clipc_add_effect(TARGET EFFECT water.fx
#     [NAME water]               # of what is written; the effect's file name without its extension
#     [TARGET glsl330]           # the GLSL to write: one with uniform blocks
#     [DEFINES A B=1] [OPTIONS --lower=clip-distance ...])
#
# compiles every pass of an effect whenever the effect or a file that it includes has changed. The target gets an include folder with
# NAME.effect.h: static const clipc_gl_effect_table NAME_effect, for effect-runtime/effect.h.
#
# The compiler is CLIPC_EXECUTABLE if that is set, as when cross-compiling; else that of this build or of the installed package.

if(CMAKE_VERSION VERSION_LESS 3.20)
  message(FATAL_ERROR "clipc_add_shader needs CMake 3.20 or later")
endif()

set(CLIPC_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_shaders.cmake)

# Sets `variable` to the compiler.
function(clipc_find_compiler variable)
  if(NOT CLIPC_EXECUTABLE AND TARGET clipc)
    set(compiler $<TARGET_FILE:clipc>)
  elseif(NOT CLIPC_EXECUTABLE AND TARGET clipc::clipc)
    set(compiler $<TARGET_FILE:clipc::clipc>)
  else()
    find_program(CLIPC_EXECUTABLE clipc REQUIRED)
    set(compiler ${CLIPC_EXECUTABLE})
  endif()
  set(${variable} ${compiler} PARENT_SCOPE)
endfunction()

# clipc_check_arguments(CALL NEEDED VALUE UNKNOWN WORDS): stops at the arguments UNKNOWN, which are not among WORDS, and where the
# argument NEEDED has no VALUE.
function(clipc_check_arguments call needed value unknown words)
  if(unknown)
    list(POP_BACK words last)
    list(JOIN words ", " words)
    message(FATAL_ERROR "${call}: what is `${unknown}`? It has ${words} and ${last}")
  elseif("${value}" STREQUAL "")
    message(FATAL_ERROR "${call}: ${needed} is missing")
  endif()
endfunction()

function(clipc_add_shader target)
  set(flags SPIRV PAIR)
  set(single SHADER NAME ENTRY PROFILE LOWER TARGET FRAGMENT PIXEL_SHADER PIXEL_ENTRY TABLE VARIANTS STRUCT_PREFIX)
  set(several DEFINES OPTIONS REFLECT)
  cmake_parse_arguments(PARSE_ARGV 1 shader "${flags}" "${single}" "${several}")
  clipc_check_arguments("clipc_add_shader(${target} SHADER file ...)" SHADER "${shader_SHADER}" "${shader_UNPARSED_ARGUMENTS}"
    "${single};${flags};${several}")
  clipc_find_compiler(compiler)

  cmake_path(ABSOLUTE_PATH shader_SHADER OUTPUT_VARIABLE source)
  if(NOT shader_NAME)
    cmake_path(GET shader_SHADER STEM shader_NAME)
  endif()
  if(NOT shader_NAME MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "clipc_add_shader(${target} SHADER ${shader_SHADER}): `${shader_NAME}` cannot name a constant; "
      "give another NAME")
  endif()
  get_target_property(names ${target} CLIPC_SHADER_NAMES)
  if(shader_NAME IN_LIST names)
    message(FATAL_ERROR "clipc_add_shader(${target} SHADER ${shader_SHADER}): the target has a shader `${shader_NAME}` already; "
      "give another NAME")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY CLIPC_SHADER_NAMES ${shader_NAME})
  if(shader_VARIANTS AND NOT shader_VARIANTS MATCHES "^[0-6]$")
    message(FATAL_ERROR "clipc_add_shader(${target} SHADER ${shader_SHADER}): VARIANTS ${shader_VARIANTS} is not a number of planes, 0 to 6")
  endif()
  if(shader_SPIRV AND NOT shader_TARGET)
    set(shader_TARGET vulkan)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  file(MAKE_DIRECTORY ${folder})
  set(stage vert)
  if(shader_PROFILE MATCHES "^ps_")
    set(stage frag)
  elseif(shader_PROFILE MATCHES "^gs_")
    set(stage geom)
  elseif(shader_PROFILE MATCHES "^hs_")
    set(stage tesc)
  elseif(shader_PROFILE MATCHES "^ds_")
    set(stage tese)
  elseif(shader_PROFILE MATCHES "^cs_")
    set(stage comp)
  endif()
  set(glsl ${folder}/${shader_NAME}.${stage})
  set(header ${folder}/${shader_NAME}.shader.h)

  set(arguments)
  foreach(option ENTRY=-E PROFILE=-T LOWER=--lower TARGET=--target PIXEL_ENTRY=--pixel-entry)
    string(REGEX MATCH "^(.*)=(.*)$" unused ${option})
    if(shader_${CMAKE_MATCH_1})
      list(APPEND arguments ${CMAKE_MATCH_2} ${shader_${CMAKE_MATCH_1}})
    endif()
  endforeach()
  foreach(define IN LISTS shader_DEFINES)
    list(APPEND arguments -D ${define})
  endforeach()
  set(stems ${folder}/${shader_NAME})
  if(DEFINED shader_VARIANTS)
    list(APPEND arguments --variants=${shader_VARIANTS})
    set(stems)
    foreach(count RANGE ${shader_VARIANTS})
      list(APPEND stems ${folder}/${shader_NAME}.${count})
    endforeach()
  endif()
  list(TRANSFORM stems APPEND .${stage} OUTPUT_VARIABLE written)
  set(fragment)
  if(shader_PIXEL_ENTRY AND NOT shader_PIXEL_SHADER)
    set(shader_PAIR TRUE)
  endif()
  if(shader_PAIR AND shader_FRAGMENT)
    message(FATAL_ERROR "clipc_add_shader(${target} SHADER ${shader_SHADER}): clipc writes the pixel shader of a PAIR; give no FRAGMENT")
  endif()
  if(shader_PAIR)
    list(APPEND arguments --pixel-output=${folder}/${shader_NAME}.frag)
    list(TRANSFORM stems APPEND .frag OUTPUT_VARIABLE fragment)
  endif()
  if(shader_FRAGMENT)
    cmake_path(ABSOLUTE_PATH shader_FRAGMENT)
    list(APPEND arguments --fragment=${shader_FRAGMENT})
    list(TRANSFORM stems APPEND .frag OUTPUT_VARIABLE fragment)
  endif()
  if("REFLECT" IN_LIST shader_KEYWORDS_MISSING_VALUES)
    set(shader_REFLECT json)
  endif()
  set(reflection)
  foreach(form IN LISTS shader_REFLECT)
    if(NOT form MATCHES "^(json|h)$")
      message(FATAL_ERROR "clipc_add_shader(${target} SHADER ${shader_SHADER}): REFLECT ${form} is not a form of the reflection; it is json or h")
    endif()
    list(APPEND reflection ${folder}/${shader_NAME}.reflect.${form})
    list(APPEND arguments --reflect=${folder}/${shader_NAME}.reflect.${form})
  endforeach()
  if(shader_STRUCT_PREFIX)
    list(APPEND arguments --struct-prefix=${shader_STRUCT_PREFIX})
  endif()

  set(spirv_arguments ${arguments})
  list(FILTER spirv_arguments EXCLUDE REGEX "^--(reflect|struct-prefix|fragment|pixel-output)=")
  if(shader_PAIR)
    list(APPEND spirv_arguments --pixel-output=${folder}/${shader_NAME}.frag.spv)
  endif()
  if(shader_PIXEL_SHADER)
    cmake_path(ABSOLUTE_PATH shader_PIXEL_SHADER)
    list(APPEND arguments --pixel-shader=${shader_PIXEL_SHADER})
    list(APPEND spirv_arguments --pixel-shader=${shader_PIXEL_SHADER})
  endif()

  set(tables ${folder}/${shader_NAME}.clip.h)
  if(shader_TABLE AND NOT shader_TABLE MATCHES "^[.]")
    set(shader_TABLE .${shader_TABLE})
  endif()
  if(shader_TABLE AND NOT shader_TABLE STREQUAL ".h")
    list(APPEND tables ${folder}/${shader_NAME}.clip${shader_TABLE})
  endif()
  list(TRANSFORM tables PREPEND --table= OUTPUT_VARIABLE table_options)
  if(NOT stage STREQUAL "vert")
    set(tables)
    set(table_options)
  endif()
  set(commands COMMAND ${compiler} ${source} -o ${glsl} ${arguments} ${shader_OPTIONS} ${table_options}
    -MD -MF ${header}.d -MT ${header})
  set(spirv)
  if(shader_SPIRV)
    set(words ${folder}/${shader_NAME}.spv)
    set(spirv ${words})
    if(shader_PAIR)
      list(APPEND spirv ${folder}/${shader_NAME}.frag.spv)
    endif()
    if(DEFINED shader_VARIANTS)
      set(modules ${spirv})
      set(spirv)
      foreach(count RANGE ${shader_VARIANTS})
        list(TRANSFORM modules REPLACE "[.]spv$" ".${count}.spv" OUTPUT_VARIABLE variant)
        list(APPEND spirv ${variant})
      endforeach()
    endif()
    list(APPEND spirv ${words}.h)
    set(kind -spirv)
    if(NOT shader_TARGET STREQUAL "vulkan")
      set(kind -G)
    endif()
    set(option)
    if(tables)
      list(GET table_options 0 option)  # a table of the same contents; under level9 clipc wants one
    endif()
    list(APPEND commands COMMAND ${compiler} ${source} ${kind} -w ${spirv_arguments} ${shader_OPTIONS} ${option}
      -o ${words} -Fh ${words}.h -Vn ${shader_NAME}_spv)
  endif()
  string(JOIN "|" glsl_list ${written})
  string(JOIN "|" fragment_list ${fragment})
  add_custom_command(OUTPUT ${header}
    BYPRODUCTS ${written} ${fragment} ${tables} ${reflection} ${spirv}
    ${commands}
    COMMAND ${CMAKE_COMMAND} "-DNAME=${shader_NAME}" "-DSTAGE=${stage}" "-DGLSL=${glsl_list}" "-DFRAGMENT=${fragment_list}"
      "-DVARIANTS=${shader_VARIANTS}" "-DTABLE=${folder}/${shader_NAME}.clip.h" "-DSPIRV=${shader_SPIRV}" "-DHEADER=${header}"
      -P ${CLIPC_EMBED_SCRIPT}
    DEPENDS ${source} ${shader_FRAGMENT} ${shader_PIXEL_SHADER} ${compiler} ${CLIPC_EMBED_SCRIPT}
    DEPFILE ${header}.d
    COMMENT "Compiling shader ${shader_NAME}"
    VERBATIM)
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
  set_target_properties(${target} PROPERTIES CLIPC_SHADER_FOLDER ${folder})
endfunction()

# Sets `command` to the words of THEN for one file, and `outputs` to the files that it writes.
function(clipc_expand_then hlsl output defines includes)
  set(command)
  set(outputs)
  foreach(word IN LISTS ARGN)
    if(word STREQUAL "{defines}")
      list(APPEND command ${defines})
    elseif(word STREQUAL "{includes}")
      list(APPEND command ${includes})
    else()
      string(REGEX MATCHALL "{output}[A-Za-z0-9_.+-]*" named "${word}")
      string(REPLACE "{output}" "${output}" named "${named}")
      list(APPEND outputs ${named})
      string(REPLACE "{hlsl}" "${hlsl}" word "${word}")
      string(REPLACE "{output}" "${output}" word "${word}")
      list(APPEND command "${word}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES outputs)
  set(command "${command}" PARENT_SCOPE)
  set(outputs "${outputs}" PARENT_SCOPE)
endfunction()

function(clipc_add_hlsl_pass target)
  set(several FILES ENTRIES DEFINES INCLUDES OPTIONS THEN)
  cmake_parse_arguments(PARSE_ARGV 1 pass "" PROFILE "${several}")
  clipc_check_arguments("clipc_add_hlsl_pass(${target} FILES file ...)" FILES "${pass_FILES}" "${pass_UNPARSED_ARGUMENTS}"
    "PROFILE;${several}")
  foreach(placeholder {hlsl} {output})
    string(FIND "${pass_THEN}" ${placeholder} found)
    if(pass_THEN AND found EQUAL -1)
      message(FATAL_ERROR "clipc_add_hlsl_pass(${target} THEN ...): the command has no `${placeholder}`; "
        "it reads {hlsl} and writes {output} with an extension, as in `-o {output}.spv`")
    endif()
  endforeach()
  clipc_find_compiler(compiler)

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_hlsl)
  file(MAKE_DIRECTORY ${folder})
  list(TRANSFORM pass_DEFINES PREPEND -D OUTPUT_VARIABLE defines)
  set(includes)
  foreach(include IN LISTS pass_INCLUDES)
    cmake_path(ABSOLUTE_PATH include NORMALIZE)
    list(APPEND includes -I${include})
  endforeach()
  list(TRANSFORM pass_ENTRIES PREPEND -E OUTPUT_VARIABLE entries)
  if(pass_PROFILE)
    list(APPEND entries -T ${pass_PROFILE})
  endif()

  foreach(file IN LISTS pass_FILES)
    cmake_path(ABSOLUTE_PATH file NORMALIZE OUTPUT_VARIABLE source)
    cmake_path(GET source STEM LAST_ONLY name)
    cmake_path(GET source PARENT_PATH source_folder)
    get_target_property(names ${target} CLIPC_HLSL_NAMES)
    if(name IN_LIST names)
      message(FATAL_ERROR "clipc_add_hlsl_pass(${target} FILES ${file}): the target has a file `${name}` already; give it another target")
    endif()
    set_property(TARGET ${target} APPEND PROPERTY CLIPC_HLSL_NAMES ${name})
    set(hlsl ${folder}/${name}.hlsl)
    add_custom_command(OUTPUT ${hlsl}
      COMMAND ${compiler} ${source} --target=hlsl ${entries} ${defines} ${includes} ${pass_OPTIONS} -o ${hlsl} -MD -MF ${hlsl}.d -MT ${hlsl}
      DEPENDS ${source} ${compiler}
      DEPFILE ${hlsl}.d
      COMMENT "Writing the clip planes of ${name} as clip distances"
      VERBATIM)
    # As a header, because Visual Studio compiles other HLSL by itself.
    set_source_files_properties(${hlsl} PROPERTIES HEADER_FILE_ONLY ON)
    target_sources(${target} PRIVATE ${hlsl})
    if(pass_THEN)
      clipc_expand_then(${hlsl} ${folder}/${name} "${defines}" "-I${source_folder};${includes}" ${pass_THEN})
      add_custom_command(OUTPUT ${outputs} COMMAND ${command} DEPENDS ${hlsl} COMMENT "Compiling ${name}" VERBATIM)
      target_sources(${target} PRIVATE ${outputs})
    endif()
  endforeach()
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "UTILITY")
    target_include_directories(${target} PRIVATE ${folder})
  endif()
  set_target_properties(${target} PROPERTIES CLIPC_HLSL_FOLDER ${folder})
endfunction()

function(clipc_add_effect target)
  cmake_parse_arguments(PARSE_ARGV 1 effect "" "EFFECT;NAME;TARGET" "DEFINES;OPTIONS")
  clipc_check_arguments("clipc_add_effect(${target} EFFECT file ...)" EFFECT "${effect_EFFECT}" "${effect_UNPARSED_ARGUMENTS}"
    "EFFECT;NAME;TARGET;DEFINES;OPTIONS")
  clipc_find_compiler(compiler)
  cmake_path(ABSOLUTE_PATH effect_EFFECT OUTPUT_VARIABLE source)
  if(NOT effect_NAME)
    cmake_path(GET effect_EFFECT STEM effect_NAME)
  endif()
  if(NOT effect_NAME MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "clipc_add_effect(${target} EFFECT ${effect_EFFECT}): `${effect_NAME}` cannot name a constant; give another NAME")
  endif()
  get_target_property(names ${target} CLIPC_EFFECT_NAMES)
  if(effect_NAME IN_LIST names)
    message(FATAL_ERROR "clipc_add_effect(${target} EFFECT ${effect_EFFECT}): the target has an effect `${effect_NAME}` already; "
      "give another NAME")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY CLIPC_EFFECT_NAMES ${effect_NAME})
  if(NOT effect_TARGET)
    set(effect_TARGET glsl330)
  endif()
  list(TRANSFORM effect_DEFINES PREPEND -D)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(header ${folder}/${effect_NAME}.effect.h)
  file(MAKE_DIRECTORY ${folder}/${effect_NAME}.effect)
  add_custom_command(OUTPUT ${header}
    COMMAND ${compiler} --effect ${source} -o ${folder}/${effect_NAME}.effect --target=${effect_TARGET} --reflect=.json
      ${effect_DEFINES} ${effect_OPTIONS} -Fh ${header} -Vn ${effect_NAME}_effect -MD -MF ${header}.d -MT ${header}
    DEPENDS ${source} ${compiler}
    DEPFILE ${header}.d
    COMMENT "Compiling effect ${effect_NAME}"
    VERBATIM)
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()

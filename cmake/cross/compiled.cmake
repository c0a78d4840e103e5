# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `clang_slice`, `glslang_slice` and `spirv_listing`, compiled from Debian's sources; cmake/cross/libraries.cmake includes this file.
if(NOT EXISTS ${LLVM_SOURCE}/clang/lib/Lex/Lexer.cpp OR NOT EXISTS ${GLSLANG_SOURCE}/glslang/GenericCodeGen/CodeGen.cpp)
  message(FATAL_ERROR "no sources of LLVM and glslang in ${CLIPC_SOURCES}; cmake/cross/fetch_sources.sh puts them there")
endif()

# theirs(TARGET FOLDER names): a static library of FOLDER/name.cpp, without our warnings.
function(theirs target folder)
  list(TRANSFORM ARGN PREPEND ${folder}/)
  list(TRANSFORM ARGN APPEND .cpp)
  add_library(${target} STATIC ${ARGN})
  target_compile_options(${target} PRIVATE -w)
endfunction()

# The C++ library's missing parts come first, since the others link with them.
if(CLIPC_WASM)
  include(${clipc_SOURCE_DIR}/web/wasm/libraries.cmake)
  set(glslang_system ${clipc_SOURCE_DIR}/web/wasm/glslang_system.cpp)
else()
  set(glslang_system ${GLSLANG_SOURCE}/glslang/OSDependent/Windows/ossource.cpp)
endif()

# ---- Clang's preprocessor

set(support ${LLVM_SOURCE}/llvm/lib)
set(clang ${LLVM_SOURCE}/clang/lib)
theirs(llvm_support ${support}
  Demangle/ItaniumDemangle
  Support/ABIBreak Support/APFloat Support/APInt Support/Allocator Support/CommandLine Support/ConvertUTF
  Support/ConvertUTFWrapper Support/Debug Support/DebugCounter Support/Errno Support/Error Support/ErrorHandling
  Support/ExtensibleRTTI Support/FoldingSet Support/FormatVariadic Support/Locale Support/MD5 Support/ManagedStatic
  Support/MemAlloc Support/MemoryBuffer Support/MemoryBufferRef Support/NativeFormatting Support/Path Support/PrettyStackTrace
  Support/Process Support/RISCVISAUtils Support/Signposts Support/SmallPtrSet Support/SmallVector Support/SourceMgr Support/Statistic
  Support/StringExtras Support/StringMap Support/StringRef Support/StringSaver Support/Threading Support/Timer Support/Twine
  Support/TypeSize Support/Unicode Support/UnicodeNameToCodepoint Support/UnicodeNameToCodepointGenerated Support/VersionTuple
  Support/VirtualFileSystem Support/WithColor Support/YAMLParser Support/raw_ostream Support/xxhash
  TargetParser/AArch64TargetParser TargetParser/ARMTargetParser TargetParser/ARMTargetParserCommon TargetParser/CSKYTargetParser
  TargetParser/LoongArchTargetParser TargetParser/RISCVISAInfo TargetParser/RISCVTargetParser TargetParser/TargetParser
  TargetParser/Triple TargetParser/X86TargetParser)
theirs(clang_lex ${clang}
  Basic/Attributes Basic/Builtins Basic/CLWarnings Basic/CharInfo Basic/Cuda Basic/Diagnostic Basic/DiagnosticIDs
  Basic/FileEntry Basic/FileManager Basic/FileSystemStatCache Basic/IdentifierTable Basic/LangOptions Basic/LangStandards
  Basic/Module Basic/OpenCLOptions Basic/ParsedAttrInfo Basic/SourceLocation Basic/SourceManager Basic/TargetID
  Basic/TargetInfo Basic/TokenKinds
  Edit/Commit Edit/EditedSource Frontend/DiagnosticRenderer Frontend/TextDiagnostic
  Lex/HeaderMap Lex/HeaderSearch Lex/Lexer Lex/LiteralSupport Lex/MacroArgs Lex/MacroInfo Lex/ModuleMap Lex/PPCaching
  Lex/PPCallbacks Lex/PPConditionalDirectiveRecord Lex/PPDirectives Lex/PPExpressions Lex/PPLexerChange Lex/PPMacroExpansion
  Lex/Pragma Lex/PreprocessingRecord Lex/Preprocessor Lex/PreprocessorLexer Lex/ScratchBuffer Lex/TokenLexer)
target_sources(clang_lex PRIVATE ${CMAKE_CURRENT_LIST_DIR}/llvm_system.cpp)
target_link_libraries(clang_lex PRIVATE llvm_support)
foreach(library llvm_support clang_lex)
  set_target_properties(${library} PROPERTIES CXX_STANDARD 17 UNITY_BUILD OFF)
  target_compile_options(${library} PRIVATE -fno-exceptions -fno-rtti)
  target_include_directories(${library} SYSTEM PRIVATE ${CLIPC_LLVM_CONFIG} ${CLIPC_LLVM_PREFIX}/include)
endforeach()
add_library(clang_slice INTERFACE)
target_include_directories(clang_slice SYSTEM INTERFACE ${CLIPC_LLVM_CONFIG} ${CLIPC_LLVM_PREFIX}/include)
target_link_libraries(clang_slice INTERFACE clang_lex llvm_support)

# ---- glslang

file(GLOB machine ${GLSLANG_SOURCE}/glslang/MachineIndependent/*.cpp ${GLSLANG_SOURCE}/glslang/MachineIndependent/preprocessor/*.cpp)
add_library(glslang_slice STATIC ${machine}
  ${GLSLANG_SOURCE}/glslang/GenericCodeGen/CodeGen.cpp ${GLSLANG_SOURCE}/glslang/GenericCodeGen/Link.cpp
  ${GLSLANG_SOURCE}/OGLCompilersDLL/InitializeDll.cpp ${GLSLANG_SOURCE}/StandAlone/ResourceLimits.cpp
  ${glslang_system})
set_target_properties(glslang_slice PROPERTIES CXX_STANDARD 17 UNITY_BUILD OFF)
target_compile_options(glslang_slice PRIVATE -w -fno-exceptions -fno-rtti)
target_include_directories(glslang_slice PRIVATE ${GLSLANG_SOURCE} ${GLSLANG_SOURCE}/StandAlone)
target_compile_definitions(glslang_slice PRIVATE ENABLE_OPT=0)

# ---- SPIRV-Tools' listing, whose tables are made of the grammar that Debian's spirv-headers has

set(spirv_tables ${CMAKE_BINARY_DIR}/spirv_tables)
set(grammars /usr/include/spirv/unified1)
file(MAKE_DIRECTORY ${spirv_tables})
find_package(Python3 REQUIRED COMPONENTS Interpreter)
function(spirv_table script)
  execute_process(COMMAND ${Python3_EXECUTABLE} ${SPIRV_TOOLS_SOURCE}/utils/${script} ${ARGN}
    WORKING_DIRECTORY ${spirv_tables} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
spirv_table(generate_grammar_tables.py --output-language=c++
  --spirv-core-grammar=${grammars}/spirv.core.grammar.json
  --extinst-debuginfo-grammar=${grammars}/extinst.debuginfo.grammar.json
  --extinst-cldebuginfo100-grammar=${grammars}/extinst.opencl.debuginfo.100.grammar.json
  --core-insts-output=core.insts-unified1.inc --operand-kinds-output=operand.kinds-unified1.inc
  --extension-enum-output=extension_enum.inc --enum-string-mapping-output=enum_string_mapping.inc)
spirv_table(generate_grammar_tables.py --output-language=c++
  --extinst-glsl-grammar=${grammars}/extinst.glsl.std.450.grammar.json --glsl-insts-output=glsl.std.450.insts.inc)
spirv_table(generate_grammar_tables.py
  --extinst-opencl-grammar=${grammars}/extinst.opencl.std.100.grammar.json --opencl-insts-output=opencl.std.insts.inc)
foreach(row "spv-amd-shader-explicit-vertex-parameter," "spv-amd-shader-trinary-minmax," "spv-amd-gcn-shader,"
            "spv-amd-shader-ballot," "debuginfo," "nonsemantic.clspvreflection," "opencl.debuginfo.100,CLDEBUG100_"
            "nonsemantic.shader.debuginfo.100,SHDEBUG100_")
  string(REGEX MATCH "(.*),(.*)" row ${row})
  spirv_table(generate_grammar_tables.py --extinst-vendor-grammar=${grammars}/extinst.${CMAKE_MATCH_1}.grammar.json
    --vendor-insts-output=${CMAKE_MATCH_1}.insts.inc --vendor-operand-kind-prefix=${CMAKE_MATCH_2})
endforeach()
spirv_table(generate_registry_tables.py --xml=${grammars}/../spir-v.xml --generator-output=generators.inc)
foreach(row DebugInfo,debuginfo OpenCLDebugInfo100,opencl.debuginfo.100
            NonSemanticShaderDebugInfo100,nonsemantic.shader.debuginfo.100)
  string(REGEX MATCH "(.*),(.*)" row ${row})
  spirv_table(generate_language_headers.py --extinst-grammar=${grammars}/extinst.${CMAKE_MATCH_2}.grammar.json
    --extinst-output-path=${CMAKE_MATCH_1}.h)
endforeach()
theirs(spirv_listing ${SPIRV_TOOLS_SOURCE}/source
  assembly_grammar binary diagnostic disassemble enum_string_mapping ext_inst extensions name_mapper opcode operand
  parsed_operand print spirv_endian spirv_target_env table text text_handler util/parse_number util/string_utils)
set_target_properties(spirv_listing PROPERTIES CXX_STANDARD 17 UNITY_BUILD OFF)
target_compile_options(spirv_listing PRIVATE -fno-exceptions -fno-rtti)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/spirv_headers)
file(CREATE_LINK /usr/include/spirv ${CMAKE_BINARY_DIR}/spirv_headers/spirv SYMBOLIC)
target_include_directories(spirv_listing
  PRIVATE ${SPIRV_TOOLS_SOURCE} ${spirv_tables} ${CMAKE_BINARY_DIR}/spirv_headers
  PUBLIC ${SPIRV_TOOLS_SOURCE}/include)

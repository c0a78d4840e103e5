# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The parts of the C++ library that Debian's archives for WebAssembly leave out, compiled from Debian's sources: exceptions, files,
# threads. cmake/cross/libraries.cmake includes this file.

set(cxx ${LLVM_SOURCE}/libcxx/src)
set(abi ${LLVM_SOURCE}/libcxxabi)
theirs(wasm_cxx ${cxx} mutex mutex_destructor condition_variable condition_variable_destructor thread
  filesystem/directory_entry filesystem/directory_iterator filesystem/operations filesystem/path filesystem/filesystem_error
  filesystem/int128_builtins)
theirs(wasm_exceptions ${abi}/src cxa_exception cxa_exception_storage cxa_personality cxa_aux_runtime)
target_sources(wasm_exceptions PRIVATE ${LLVM_SOURCE}/libunwind/src/Unwind-wasm.c ${CMAKE_CURRENT_LIST_DIR}/posix.cpp)
target_include_directories(wasm_exceptions PRIVATE ${abi}/include ${abi}/src ${LLVM_SOURCE}/libunwind/include)
foreach(library wasm_cxx wasm_exceptions)
  set_target_properties(${library} PROPERTIES CXX_STANDARD 23 UNITY_BUILD OFF)
  target_include_directories(${library} PRIVATE ${cxx})
  target_compile_definitions(${library} PRIVATE _LIBCPP_BUILDING_LIBRARY _LIBCXXABI_BUILDING_LIBRARY _LIBCXXABI_HAS_NO_THREADS
    _LIBUNWIND_HAS_NO_THREADS _LIBUNWIND_HIDE_SYMBOLS _LIBCPP_REMOVE_TRANSITIVE_INCLUDES)
endforeach()
link_libraries(wasm_cxx wasm_exceptions)

# Clang's messages are kept as far as its preprocessor has them. The texts of the others would be a tenth of the module.
set(short ${CMAKE_BINARY_DIR}/short_messages)
foreach(kind AST Analysis Comment CrossTU Driver Frontend InstallAPI Parse Refactoring Sema Serialization)
  set(messages clang/Basic/Diagnostic${kind}Kinds.inc)
  file(READ ${CLIPC_LLVM_PREFIX}/include/${messages} text)
  string(REGEX REPLACE "(Severity::[A-Za-z]+, )\"[^\n]*\"(, [0-9]+, )" "\\1\"\"\\2" text "${text}")
  file(CONFIGURE OUTPUT ${short}/${messages} CONTENT "${text}" @ONLY)
endforeach()
set_source_files_properties(${LLVM_SOURCE}/clang/lib/Basic/DiagnosticIDs.cpp PROPERTIES COMPILE_OPTIONS -I${short})

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# LLVM and glslang are found where other systems and package managers have them: configures cmake/elsewhere with folders that have
# the files' names.
#   cmake -DSCRATCH= -DGENERATOR= -DCOMPILER= -P test_elsewhere.cmake
file(REMOVE_RECURSE ${SCRATCH})

# install(NAME VERSION PREFIX SUFFIX): a folder with the files of LLVM and glslang; an archive's name has the prefix and suffix.
function(install name version before after)
  set(prefix ${SCRATCH}/${name})
  file(WRITE ${prefix}/include/clang/Basic/Version.inc "#define CLANG_VERSION_MAJOR ${version}\n")
  file(WRITE ${prefix}/include/glslang/Public/ShaderLang.h "")
  file(WRITE ${prefix}/include/glslang/MachineIndependent/localintermediate.h "")
  foreach(archive clangFrontend clangEdit clangLex clangBasic LLVMTargetParser LLVMSupport LLVMDemangle glslang SPIRV)
    file(WRITE ${prefix}/lib/${before}${archive}${after} "")
  endforeach()
endfunction()
install(here 19 lib .a)
install(newer 21 lib .a)
install(windows 19 "" .lib)

# expect(FOLDER arguments): configured with the arguments, both are found in FOLDER; `nowhere`: Clang is not.
function(expect folder)
  file(REMOVE_RECURSE ${SCRATCH}/build)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/elsewhere -B ${SCRATCH}/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
  set(wanted "clang_slice: ${SCRATCH}/${folder}/include: ${SCRATCH}/${folder}/lib/libclangFrontend.a;"
    "glslang_slice: ${SCRATCH}/${folder}/include: ${SCRATCH}/${folder}/lib/libglslang.a;")
  if(folder STREQUAL "windows")
    string(REGEX REPLACE "/lib([A-Za-z]+)[.]a" "/\\1.lib" wanted "${wanted}")
  elseif(folder STREQUAL "nowhere")
    set(wanted "no libraries of Clang 19" "CMAKE_PREFIX_PATH says" "apt-get install libclang-19-dev")
  endif()
  string(REGEX REPLACE "\n +" " " line "${said}")
  foreach(text IN LISTS wanted)
    string(FIND "${line}" "${text}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${ARGN}: expected `${text}`, got\n${said}")
    endif()
  endforeach()
endfunction()

set(here ${SCRATCH}/here)
expect(here -DCMAKE_PREFIX_PATH=${here})                                          # Homebrew, and a vcpkg toolchain
expect(here -DLLVM_DIR=${here}/lib/cmake/llvm -Dglslang_DIR=${here}/lib/cmake/glslang)
expect(here -DClang_DIR=${here}/share/clang -Dglslang_DIR=${here}/share/glslang)  # vcpkg's folders
expect(here -DCLIPC_LLVM_PREFIX=${here} -DCMAKE_PREFIX_PATH=${here})
expect(newer -DCLIPC_LLVM=21 -DCMAKE_PREFIX_PATH=${SCRATCH}/newer)
find_program(mingw NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++ NO_CACHE)
if(mingw)
  expect(windows -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_CXX_COMPILER=${mingw} -DCMAKE_PREFIX_PATH=${SCRATCH}/windows)
endif()
expect(nowhere -DCLIPC_LLVM_PREFIX=${SCRATCH}/newer)
file(REMOVE_RECURSE ${SCRATCH})

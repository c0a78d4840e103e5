# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Packages. In a build folder, `cpack -G DEB` writes clipc (the program), libclipc1 (the shared library) and libclipc-dev (headers,
# archives, CMake, pkg-config: what an application is built with), and `cpack -G TGZ` one archive of all three. For Windows,
# `cpack -G ZIP` writes that archive. Where the target `study` was built (ClipcStudy.cmake), there is clipc-study too.

set(doc share/doc/clipc)
set(packaging ${clipc_SOURCE_DIR}/packaging)

# The manual page is what --help says, so it takes a program that runs here.
if(TARGET clipc AND NOT CMAKE_CROSSCOMPILING)
  set(manual ${clipc_BINARY_DIR}/clipc.1)
  add_custom_command(OUTPUT ${manual}
    COMMAND ${CMAKE_COMMAND} -DCLIPC=$<TARGET_FILE:clipc> -DVERSION=${clipc_VERSION} -DTEMPLATE=${packaging}/clipc.1.in
      -DOUTPUT=${manual} -P ${packaging}/make_manual.cmake
    DEPENDS clipc ${packaging}/clipc.1.in ${packaging}/make_manual.cmake
    VERBATIM)
  add_custom_target(clipc_manual ALL DEPENDS ${manual})
  install(FILES ${manual} DESTINATION share/man/man1 COMPONENT compiler)
endif()
if(NOT WIN32)
  install(FILES ${packaging}/clipc.bash DESTINATION share/bash-completion/completions RENAME clipc COMPONENT compiler)
endif()
install(FILES ${clipc_SOURCE_DIR}/README.md ${clipc_SOURCE_DIR}/CHANGELOG.md DESTINATION ${doc} COMPONENT compiler)
install(FILES ${clipc_SOURCE_DIR}/LICENSE DESTINATION ${doc} COMPONENT compiler)
install(DIRECTORY ${clipc_SOURCE_DIR}/docs/ DESTINATION ${doc}/docs COMPONENT compiler
  FILES_MATCHING PATTERN *.md PATTERN *.json PATTERN *.png
  PATTERN architecture.md EXCLUDE PATTERN testing.md EXCLUDE PATTERN decisions EXCLUDE  # for contributors
  PATTERN errata.md EXCLUDE PATTERN reference-compilers.md EXCLUDE)
# The pages of diagnostics have what the program says about each example, where it runs here.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
  set(program)
  if(TARGET clipc AND NOT CMAKE_CROSSCOMPILING)
    set(program "\"$<TARGET_FILE:clipc>\"")
  endif()
  install(CODE "execute_process(COMMAND \"${Python3_EXECUTABLE}\" \"${clipc_SOURCE_DIR}/tools/checks/diagnostic_pages.py\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${doc}/docs/diagnostics\" ${program} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT compiler)
endif()
install(FILES ${clipc_SOURCE_DIR}/study/speed-accuracy.svg DESTINATION ${doc}/study COMPONENT compiler)
install(DIRECTORY ${clipc_SOURCE_DIR}/examples/first ${clipc_SOURCE_DIR}/examples/gallery ${clipc_SOURCE_DIR}/examples/pixel ${clipc_SOURCE_DIR}/examples/compute ${clipc_SOURCE_DIR}/examples/geometry ${clipc_SOURCE_DIR}/examples/tessellation
  DESTINATION ${doc}/examples COMPONENT compiler)

# The licences of what is linked in, where Debian's packages of it have them.
set(linked libclang-${CLIPC_LLVM}-dev llvm-${CLIPC_LLVM}-dev glslang-dev libfmt-dev nlohmann-json3-dev)
if(WIN32)
  list(APPEND linked g++-mingw-w64-x86-64-posix mingw-w64-x86-64-dev)
else()
  list(APPEND linked spirv-tools libstdc++-${CMAKE_CXX_COMPILER_VERSION} libc6-dev)
endif()
foreach(name IN LISTS linked)
  string(REGEX REPLACE "^(libstdc[+][+]-[0-9]+).*" "\\1-dev" name ${name})
  if(EXISTS /usr/share/doc/${name}/copyright)
    install(FILES /usr/share/doc/${name}/copyright DESTINATION ${doc}/linked RENAME ${name} COMPONENT compiler)
  endif()
endforeach()

set(CPACK_PACKAGE_NAME clipc)
set(CPACK_PACKAGE_VENDOR clipc)
set(CPACK_PACKAGE_CONTACT "clipc maintainers <clipc@packages.invalid>" CACHE STRING "who answers for the packages")
set(CPACK_RESOURCE_FILE_LICENSE ${clipc_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR TGZ)
if(WIN32)
  set(CPACK_GENERATOR ZIP)
endif()
if(CMAKE_CROSSCOMPILING AND NOT WIN32)
  set(CPACK_SYSTEM_NAME ${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL compiler library development)
set(CPACK_PRE_BUILD_SCRIPTS ${packaging}/finish_folders.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${packaging}/finish_packages.cmake)
set(CPACK_CLIPC_PACKAGING ${packaging})
set(CPACK_CLIPC_STUDY ${CLIPC_STUDY})
set(CPACK_PROJECT_CONFIG_FILE ${packaging}/add_study.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_COMPILER_PACKAGE_NAME clipc)
set(CPACK_DEBIAN_COMPILER_PACKAGE_SECTION devel)
set(CPACK_COMPONENT_COMPILER_DESCRIPTION "HLSL to GLSL and SPIR-V, with its clip planes
clipc translates vertex, hull, domain, geometry, pixel and compute shaders and
effects in HLSL into GLSL or SPIR-V. Planes of the attribute [clipplanes(...)]
become clip distances or, under feature level 9, entries of a table that tells
an application its calls of SetClipPlane.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libclipc1)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "compiler of HLSL to GLSL and SPIR-V, as a library
libclipc compiles while an application runs. Its interface is C, and it shows
no other name, so that it lives beside an LLVM of the application's.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libclipc-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "clipc (= ${clipc_VERSION}), libclipc1 (= ${clipc_VERSION}), libc6-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "runtime for shaders that clipc compiled, and files for building with it
The runtime reads the clip table, makes the constants of planes and binds them
on OpenGL. Here are its headers and archives, those of the compiler's library,
and the files for CMake, with clipc_add_shader(), and for pkg-config.")
set(CPACK_DEBIAN_STUDY_PACKAGE_NAME clipc-study)
set(CPACK_DEBIAN_STUDY_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_STUDY_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_STUDY_PACKAGE_RECOMMENDS python3-matplotlib)
set(CPACK_COMPONENT_STUDY_DESCRIPTION "measurements of ways to clip, and advice on a scene
clipc-study measures how fast and how accurate each way to clip is, on Mesa's
software OpenGL, and says which of them the objects of a scene need.")
include(CPack)

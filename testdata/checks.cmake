# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Tests of the repository itself, of its pages, and of what is installed: once, by the build that is.
if(CLIPC_SANITIZE OR CLIPC_FUZZ)
  return()
endif()
add_test(NAME layers COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_layers.py)
add_test(NAME circles COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_circles.py)
add_test(NAME format COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_format.py)
add_test(NAME sizes COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_sizes.py)
add_test(NAME scripts COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_scripts.py)
set_tests_properties(scripts PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME pages COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_pages.py)
add_test(NAME words COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_words.py)
add_test(NAME words_check COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_words.py --test)
# The numbers of the documents are those of the study's tables.
add_test(NAME numbers COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/study/program/check_numbers.py)
add_test(NAME recipes COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_recipes.py)
add_test(NAME sources COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_sources.py)
add_test(NAME fail_names COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/check_fail_names.py ${CMAKE_CURRENT_SOURCE_DIR})
add_test(NAME diagnostics COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_diagnostics.py --coverage)
add_test(NAME explanations COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_diagnostics.py --explanations $<TARGET_FILE:clipc>
  --pages ${CMAKE_CURRENT_BINARY_DIR}/diagnostics)
add_test(NAME outside_project COMMAND ${CMAKE_COMMAND} -DBUILD=${clipc_BINARY_DIR}
  -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/outside_project -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER}
  -DC_COMPILER=${CMAKE_C_COMPILER} -DNM=${CMAKE_NM}
  -P ${clipc_SOURCE_DIR}/cmake/test_outside_project.cmake)
set_tests_properties(outside_project PROPERTIES TIMEOUT 300)
if(TARGET clipc)
  add_test(NAME outside_mistakes COMMAND ${CMAKE_COMMAND} -DCLIPC=$<TARGET_FILE:clipc>
    -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/outside_mistakes -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER}
    -P ${clipc_SOURCE_DIR}/cmake/test_outside_mistakes.cmake)
  set_tests_properties(outside_mistakes PROPERTIES TIMEOUT 300)
  # The counts are of what Debian 12 compiles.
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CLIPC_STATIC AND CLIPC_LLVM EQUAL 19 AND NOT CLIPC_PROFILE AND
     CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.")
    add_test(NAME instructions COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_instructions.py $<TARGET_FILE:clipc>
      release)
    set_tests_properties(instructions PROPERTIES SKIP_RETURN_CODE 77)
  endif()
  add_test(NAME packaging COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/packaging/check_packaging.py $<TARGET_FILE:clipc>
    ${CMAKE_CURRENT_BINARY_DIR}/packaging)
  add_test(NAME packaging.recipes COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/packaging/follow_recipes.py ${clipc_BINARY_DIR}
    ${CMAKE_CURRENT_BINARY_DIR}/recipes)
  add_test(NAME packaging.slurm COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/packaging/slurm/check_slurm.py $<TARGET_FILE:clipc>
    ${CMAKE_CURRENT_BINARY_DIR}/slurm)
  set_tests_properties(packaging.recipes packaging.slurm PROPERTIES TIMEOUT 300 SKIP_RETURN_CODE 77)
  add_test(NAME snippets COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_snippets.py ${clipc_BINARY_DIR}
    ${CMAKE_CURRENT_BINARY_DIR}/snippets ${CMAKE_C_COMPILER} ${CMAKE_CXX_COMPILER})
  add_test(NAME examples.builds COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/examples/builds/check_builds.py ${clipc_BINARY_DIR}
    ${CMAKE_CURRENT_BINARY_DIR}/builds)
  set_tests_properties(snippets examples.builds PROPERTIES TIMEOUT 600)
  find_program(DOXYGEN doxygen)
  if(DOXYGEN)
    add_test(NAME reference COMMAND ${Python3_EXECUTABLE} ${clipc_SOURCE_DIR}/tools/checks/check_reference.py ${DOXYGEN}
      ${clipc_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/reference)
  endif()
endif()
add_test(NAME fetch_content COMMAND ${CMAKE_COMMAND} -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/fetch_content
  -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${clipc_SOURCE_DIR}/cmake/test_fetch_content.cmake)
set_tests_properties(fetch_content PROPERTIES SKIP_REGULAR_EXPRESSION "nothing was fetched" TIMEOUT 300)
add_test(NAME elsewhere COMMAND ${CMAKE_COMMAND} -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/elsewhere -DGENERATOR=${CMAKE_GENERATOR}
  -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${clipc_SOURCE_DIR}/cmake/test_elsewhere.cmake)
add_test(NAME update_checks COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/update_checks_test.py ${FILECHECK})

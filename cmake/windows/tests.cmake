# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The tests of the preset `windows`, on a machine with Wine: clipc.exe under lit, its output beside the native program's, the
# archive. The unit tests that CLIPC_UNIT_TESTS names are made as everywhere, by clipc_folder().
set(CLIPC_NATIVE ${clipc_SOURCE_DIR}/build/release/bin/clipc CACHE FILEPATH "a native clipc of the same sources, to compare with")
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# One word that starts clipc.exe, for lit and scripts.
set(CLIPC_UNDER_WINE ${CMAKE_BINARY_DIR}/clipc-under-wine)
file(GENERATE OUTPUT ${CLIPC_UNDER_WINE} CONTENT "#!/bin/sh\nexec ${CMAKE_CURRENT_LIST_DIR}/wine.sh ${CMAKE_BINARY_DIR}/wine $<TARGET_FILE:clipc> \"$@\"\n"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# Wine's folder is made once, before the tests that use it.
add_test(NAME windows.wine COMMAND ${CLIPC_UNDER_WINE} --version)
set_tests_properties(windows.wine PROPERTIES FIXTURES_SETUP wine TIMEOUT 300 PASS_REGULAR_EXPRESSION "^clipc ")

add_test(NAME windows.imports COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_imports.py ${CMAKE_OBJDUMP}
  $<TARGET_FILE:clipc> $<TARGET_FILE:clipc_shared>)
add_test(NAME windows.archive COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_archive.py ${CMAKE_CPACK_COMMAND}
  ${CMAKE_BINARY_DIR} ${CMAKE_CURRENT_LIST_DIR}/wine.sh ${CMAKE_C_COMPILER})
add_test(NAME windows.same_bytes COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_bytes.py ${CLIPC_NATIVE}
  ${CLIPC_UNDER_WINE} ${CMAKE_BINARY_DIR}/same_bytes)
set_tests_properties(windows.same_bytes PROPERTIES FIXTURES_REQUIRED wine TIMEOUT 1200)
set_tests_properties(windows.archive PROPERTIES FIXTURES_REQUIRED wine TIMEOUT 300)

# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# CPack runs this before anything else. It packs the laboratory too where the target `study` has built it.
if(EXISTS ${CPACK_CLIPC_STUDY}/bin/clipc-study)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${CPACK_CLIPC_STUDY} clipc_study study /)
  list(APPEND CPACK_COMPONENTS_ALL study)
  set(CPACK_COMPONENTS_STUDY study)  # of the project whose group of components is STUDY
endif()

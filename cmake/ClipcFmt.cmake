# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# `clipc_fmt`: fmt as a static library. The header-only form is compiled again in each file that formats a text, a sixth of the time
# of a build. Debian has the headers and a shared library, which a static program cannot link.
if(NOT CLIPC_FROM_SOURCES)  # or cmake/cross/libraries.cmake has found fmt's headers
  find_package(fmt REQUIRED)
endif()

set(type)
if(TARGET fmt::fmt)
  get_target_property(type fmt::fmt TYPE)
endif()
if(type STREQUAL "STATIC_LIBRARY")
  add_library(clipc_fmt ALIAS fmt::fmt)
elseif(fmt_VERSION VERSION_LESS 11)
  add_library(clipc_fmt STATIC ${CMAKE_CURRENT_LIST_DIR}/fmt.cpp)
  get_target_property(include fmt::fmt-header-only INTERFACE_INCLUDE_DIRECTORIES)
  if(include)
    target_include_directories(clipc_fmt SYSTEM PUBLIC ${include})
  endif()
else()
  add_library(clipc_fmt ALIAS fmt::fmt-header-only)
endif()

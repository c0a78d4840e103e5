# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# An overlay port, which builds the sources that it lies in: vcpkg install clipc --overlay-ports=packaging/vcpkg
set(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../../..)

vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH}
  OPTIONS -DBUILD_TESTING=OFF -DCLIPC_WERROR=OFF -DCLIPC_STATIC=OFF -DCLIPC_LLVM_PREFIX=${CURRENT_INSTALLED_DIR})
vcpkg_cmake_install()
vcpkg_copy_tools(TOOL_NAMES clipc AUTO_CLEAN)
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/clipc)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)

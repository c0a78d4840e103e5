# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# CPack runs this on the folders of the components before it packs them. It adds what lintian wants of a Debian package.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

# The time of SOURCE_DATE_EPOCH, if that is set.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)

function(compress file)
  execute_process(COMMAND gzip -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
  set(doc ${root}/share/doc/${name})
  file(COPY ${CPACK_CLIPC_PACKAGING}/copyright DESTINATION ${doc})
  file(WRITE ${doc}/changelog "clipc (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
    "  * /usr/share/doc/clipc/CHANGELOG.md.gz lists what changed.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  compress(${doc}/changelog)
  file(GLOB manuals ${root}/share/man/man1/*.1)
  foreach(manual IN LISTS manuals)
    compress(${manual})
  endforeach()
  if(EXISTS ${CPACK_CLIPC_PACKAGING}/lintian/${name})
    file(COPY ${CPACK_CLIPC_PACKAGING}/lintian/${name} DESTINATION ${root}/share/lintian/overrides)
  endif()
endforeach()

# pkg-config for another machine looks into folders with the machine's name.
set(root ${CPACK_TEMPORARY_DIRECTORY}/development${CPACK_PACKAGING_INSTALL_PREFIX}/lib)
execute_process(COMMAND dpkg-architecture -qDEB_HOST_MULTIARCH OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
file(MAKE_DIRECTORY ${root}/${machine})
file(RENAME ${root}/pkgconfig ${root}/${machine}/pkgconfig)
file(GLOB files ${root}/${machine}/pkgconfig/*.pc)
foreach(file IN LISTS files)
  file(READ ${file} text)
  string(REPLACE "/../.." "/../../.." text "${text}")
  file(WRITE ${file} "${text}")
endforeach()

set(root ${CPACK_TEMPORARY_DIRECTORY}/compiler${CPACK_PACKAGING_INSTALL_PREFIX}/share)
compress(${root}/doc/clipc/CHANGELOG.md)
file(REMOVE ${root}/doc/clipc/LICENSE)  # it is `copyright`
file(GLOB archives ${CPACK_TEMPORARY_DIRECTORY}/development${CPACK_PACKAGING_INSTALL_PREFIX}/lib/*.a)
foreach(archive IN LISTS archives)
  execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note --enable-deterministic-archives ${archive}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB libraries ${CPACK_TEMPORARY_DIRECTORY}/library${CPACK_PACKAGING_INSTALL_PREFIX}/lib/*.so.*)
foreach(library IN LISTS libraries)
  if(NOT IS_SYMLINK ${library})
    file(CHMOD ${library} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  endif()
endforeach()

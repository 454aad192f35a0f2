# Lets `cpack` in the build folder make crossfield_VERSION_ARCHITECTURE.deb; scripts/deb.sh calls it and checks the
# package. The package holds what `cmake --install` installs, in /usr, and the files that Debian and ParaView
# require. Only for the build against ParaView.

set(extra "${CMAKE_BINARY_DIR}/debian")
set(doc "share/doc/crossfield")
if (ParaView_VERSION VERSION_LESS 5.13)
  # ParaView reads a file that names lists of plugins: paraview.conf in the folder of its program. Debian 12 has
  # no such file.
  configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/paraview.conf.in"
    "${extra}/${CMAKE_INSTALL_BINDIR}/paraview.conf" @ONLY)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/crossfield.plugins.xml"
    "${extra}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/crossfield.plugins.xml" COPYONLY)
endif ()
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/copyright" "${extra}/${doc}/copyright" COPYONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/lintian-overrides"
  "${extra}/share/lintian/overrides/crossfield" COPYONLY)

# The release of the system is part of the version: packages for different releases differ, and a system that is
# upgraded to the next release takes the package for it.
cmake_host_system_information(RESULT system QUERY DISTRIB_ID DISTRIB_VERSION_ID)
list(JOIN system "" system)
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~${system}") # 1~debian12
set(maintainer "crossfield maintainers <maintainers@users.noreply.h-seed-411bf44f.example>") # author of the commits

# Two changelogs: that of the project, and that of the package. Its date is not that of the build, which would change
# the package with every build. gzip -n leaves out times too, which file(ARCHIVE_CREATE) cannot.
file(TIMESTAMP "${PROJECT_SOURCE_DIR}/CHANGELOG.md" date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in" "${extra}/${doc}/changelog.Debian" @ONLY)
file(COPY_FILE "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${extra}/${doc}/changelog")
execute_process(COMMAND gzip -9nf changelog changelog.Debian
  WORKING_DIRECTORY "${extra}/${doc}" COMMAND_ERROR_IS_FATAL ANY)
# Sets permissions independently of the umask.
file(CHMOD_RECURSE "${extra}"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
  DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)

if (NOT ParaView_VERSION VERSION_LESS 5.13)
  # The ParaView of Debian 13 lists the plugins in this folder.
  set(folder "share/paraview/plugins/CrossFieldPlugin")
  file(MAKE_DIRECTORY "${extra}/${folder}")
  file(CREATE_LINK "../../../../${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/CrossFieldPlugin/CrossFieldPlugin.so"
    "${extra}/${folder}/CrossFieldPlugin.so" SYMBOLIC)
endif ()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME crossfield)
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALLED_DIRECTORIES "${extra};/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# Dependencies that the libraries do not show: the Python modules of ParaView. (The libraries depend on
# exactly the version of ParaView that they were built for.)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-paraview, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/debian/prerm" "${CMAKE_CURRENT_LIST_DIR}/debian/triggers")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview-dev, mpi-default-bin")
# CPack puts the description of the project before this text and indents the lines.
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "\
A cross field attaches four orthogonal directions to every point of a planar
domain; quad meshers follow it. These filters compute the smoothest field that
is aligned with the boundary and has exactly the requested singularities.
.
The package contains the program crossfield, the Python package crossfield, the
plugin CrossFieldPlugin for ParaView, and the C++ library with its headers,
which need paraview-dev.")
# Adds the manual page, which the program itself prints.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian/ManualPage.cmake")
include(CPack)

# Lets `cpack` in the build folder make crossfield_VERSION_ARCHITECTURE.deb. The package holds what
# `cmake --install` installs, in /usr, and the files that Debian and ParaView require. Only for the build
# against ParaView.

# ParaView reads a file that names lists of plugins: paraview.conf in the folder of its program. Debian's
# packages of ParaView have no such file.
set(extra "${CMAKE_BINARY_DIR}/debian")
set(doc "share/doc/crossfield")
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/paraview.conf.in"
  "${extra}/${CMAKE_INSTALL_BINDIR}/paraview.conf" @ONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/crossfield.plugins.xml"
  "${extra}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/crossfield.plugins.xml" COPYONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/copyright" "${extra}/${doc}/copyright" COPYONLY)
file(ARCHIVE_CREATE OUTPUT "${extra}/${doc}/changelog.gz" PATHS "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
  FORMAT raw COMPRESSION GZip)
# Sets permissions independently of the umask.
file(CHMOD_RECURSE "${extra}"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
  DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME crossfield)
set(CPACK_PACKAGE_CONTACT
  "crossfield maintainers <maintainers@users.noreply.h-seed-411bf44f.example>") # author of the commits
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALLED_DIRECTORIES "${extra};/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Dependencies that the libraries do not show: the Python modules of ParaView. (The libraries depend on
# exactly the version of ParaView that they were built for.)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-paraview, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/debian/prerm")
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
include(CPack)

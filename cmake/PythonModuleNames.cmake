# Debian 13 renames ParaView's Python modules from NAME.so to NAME.cpython-313-x86_64-linux-gnu.so, but its
# CMake files still name NAME.so and stop because that file is missing. Nothing links to these modules. The
# CMake files do not check a target for which this variable names a folder, so set it for the renamed
# modules. Call before find_package(ParaView) or find_package(VTK).
macro (crossfield_accept_renamed_python_modules)
  foreach (_crossfield_folder IN ITEMS vtkmodules paraview/modules paraview/incubator)
    file(GLOB _crossfield_modules "/usr/lib/python3/dist-packages/${_crossfield_folder}/*.cpython-*.so")
    foreach (_crossfield_module IN LISTS _crossfield_modules)
      cmake_path(REMOVE_EXTENSION _crossfield_module OUTPUT_VARIABLE _crossfield_name)
      if (NOT EXISTS "${_crossfield_name}.so")
        cmake_path(GET _crossfield_name FILENAME _crossfield_name)
        foreach (_crossfield_namespace IN ITEMS VTK ParaView)
          set("_cmake_import_check_xcframework_for_${_crossfield_namespace}::${_crossfield_name}Python" "/usr")
        endforeach ()
      endif ()
    endforeach ()
  endforeach ()
endmacro ()

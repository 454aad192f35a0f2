# Debian 13 renames ParaView's Python modules from NAME.so to NAME.cpython-313-x86_64-linux-gnu.so, but its
# CMake files still name NAME.so and stop because that file is missing. Nothing links to these modules. The
# CMake files do not check a target for which this variable names a folder, so set it for the renamed modules.
# Call before find_package(ParaView) or find_package(VTK).
macro (crossfield_accept_renamed_python_modules)
  file(GLOB renamed_modules "/usr/lib/python3/dist-packages/vtkmodules/*.cpython-*.so"
    "/usr/lib/python3/dist-packages/paraview/modules/*.cpython-*.so"
    "/usr/lib/python3/dist-packages/paraview/incubator/*.cpython-*.so")
  foreach (renamed_module IN LISTS renamed_modules)
    get_filename_component(module_folder "${renamed_module}" DIRECTORY)
    get_filename_component(module_name "${renamed_module}" NAME)
    string(REGEX REPLACE "\\.cpython-.*" "" module_name "${module_name}")
    if (NOT EXISTS "${module_folder}/${module_name}.so")
      foreach (module_namespace IN ITEMS VTK ParaView)
        set("_cmake_import_check_xcframework_for_${module_namespace}::${module_name}Python" "${module_folder}")
      endforeach ()
    endif ()
  endforeach ()
endmacro ()

# The Python package around the wrapped classes. It is copied to ${package_directory} and installed
# from there, so build tree and installation have the same files.

# Names of arrays, generated from the C++ header.
set(header "${CMAKE_CURRENT_LIST_DIR}/../vtk/vtkCrossFieldArrayNames.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
file(STRINGS "${header}" lines REGEX "^constexpr const char\\* ")
set(names "")
foreach (line IN LISTS lines)
  string(REGEX REPLACE "^constexpr const char\\* ([A-Za-z0-9]+) = (\"[A-Za-z0-9]+\").*$"
    "\\1: Final = \\2\n" name "${line}")
  string(APPEND names "${name}")
endforeach ()

configure_file("${CMAKE_CURRENT_LIST_DIR}/__init__.py.in" "${package_directory}/__init__.py" @ONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/names.py.in" "${package_directory}/names.py" @ONLY)
set(package_files __init__.py names.py)
foreach (file IN ITEMS __init__.pyi _arguments.py _boundary.py _configurations.py _functions.py _input.py _layers.py _plot.py _quads.py _results.py
  _run.py _solid.py py.typed)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/${file}" "${package_directory}/${file}" COPYONLY)
  list(APPEND package_files "${file}")
endforeach ()
list(TRANSFORM package_files PREPEND "${package_directory}/")

# Types of the wrapped classes. The module that generates them is missing in Debian's VTK 9.1, where
# every class is Any.
if (NOT Python3_EXECUTABLE)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
endif ()
set(stub "${package_directory}/vtkCrossFieldFilters.pyi")
execute_process(
  COMMAND "${Python3_EXECUTABLE}" -c "import vtkmodules.generate_pyi"
  RESULT_VARIABLE no_generator
  OUTPUT_QUIET ERROR_QUIET)
if (no_generator)
  file(GLOB headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/../vtk/vtk*.h")
  set(types "from typing import Any\n\n")
  foreach (class_header IN LISTS headers)
    get_filename_component(class "${class_header}" NAME_WE)
    if (NOT class MATCHES "ArrayNames|Parts|PortMacro")
      string(APPEND types "${class}: Any\n")
    endif ()
  endforeach ()
  file(WRITE "${stub}" "${types}")
else ()
  set(python_path "${CMAKE_BINARY_DIR}/${python_destination}:$ENV{PYTHONPATH}")
  add_custom_command(OUTPUT "${stub}"
    COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${python_path}"
      "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi -p crossfield
      -o "${package_directory}" vtkCrossFieldFilters
    DEPENDS vtkCrossFieldFiltersPython ${package_files}
    COMMENT "Writing the types of the Python module")
  add_custom_target(crossfieldPythonTypes ALL DEPENDS "${stub}")
endif ()
list(APPEND package_files "${stub}")
install(FILES ${package_files} DESTINATION "${python_destination}/crossfield")

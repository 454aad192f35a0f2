# Two rules that a compiler does not enforce, run as `cmake -P`: the numerics include no VTK header
# (one on the compiler's default path would go unnoticed), and no header opens a namespace for
# everyone who includes it.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

file(GLOB_RECURSE numerics "${root}/filters/numerics/*.h" "${root}/filters/numerics/*.cxx")
file(GLOB_RECURSE headers "${root}/filters/*.h" "${root}/pipelines/*.h" "${root}/tests/*.h")
if (NOT numerics OR NOT headers)
  message(FATAL_ERROR "No sources found under ${root}; the rules were not checked.")
endif ()

set(violations "")
foreach (file IN LISTS numerics)
  file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]vtk")
  foreach (line IN LISTS lines)
    string(APPEND violations "\n  ${file}: ${line}")
  endforeach ()
endforeach ()
foreach (file IN LISTS headers)
  file(STRINGS "${file}" lines REGEX "^[ \t]*using[ \t]+namespace")
  foreach (line IN LISTS lines)
    string(APPEND violations "\n  ${file}: ${line}")
  endforeach ()
endforeach ()
if (violations)
  message(FATAL_ERROR
    "VTK in filters/numerics, or `using namespace` in a header:${violations}")
endif ()

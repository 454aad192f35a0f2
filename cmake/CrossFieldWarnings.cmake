# Warnings for all code of this project, but not for code that VTK generates. g++ 12 and 14 and clang 14
# print none of them; other compilers may, so they are errors only in builds of our own scripts. Headers of other libraries are SYSTEM headers, which print no warnings.
# -Wpedantic is missing because it complains about the semicolon after vtkTypeMacro(...); the numerics
# add it.
option(CROSSFIELD_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)

set(crossfield_warnings
  -Wall
  -Wextra
  -Wcast-align
  -Wcast-qual
  -Wconversion
  -Wdouble-promotion
  -Wformat=2
  -Wmissing-declarations
  -Wnon-virtual-dtor
  -Wold-style-cast
  -Woverloaded-virtual
  -Wshadow
  -Wundef)
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND crossfield_warnings -Wduplicated-branches -Wduplicated-cond -Wlogical-op)
endif ()
if (CMAKE_CXX_COMPILER_ID MATCHES "Clang") # whose -Wconversion includes this one, unlike that of g++
  list(APPEND crossfield_warnings -Wno-sign-conversion)
endif ()
if (CROSSFIELD_WARNINGS_AS_ERRORS)
  list(APPEND crossfield_warnings -Werror)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    list(APPEND crossfield_warnings -Wno-error=maybe-uninitialized) # false positive of g++ 14 in MergedCorners.cxx
  endif ()
endif ()

# Adds the warnings to targets: crossfield_add_warnings(TARGET...)
function(crossfield_add_warnings)
  foreach (target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE ${crossfield_warnings})
  endforeach ()
endfunction()

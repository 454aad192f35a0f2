# Precompiled headers and unity batches. They shorten compiling and change no results. All presets use them.
# Without, each file is compiled by itself, which shows whether it includes what it needs.
option(CROSSFIELD_FAST_COMPILE "Use precompiled headers and compile sources in batches" OFF)
# One batch is what compiles again after a change of one of its files.
set(CROSSFIELD_BATCH_SIZE 4 CACHE STRING "Sources per unity batch")
mark_as_advanced(CROSSFIELD_BATCH_SIZE)

# Headers of other libraries that most sources of the numerics and of the filters include.
set(crossfield_numerics_headers
  <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore> <Eigen/Cholesky>
  <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <numeric> <optional> <set>
  <sstream> <string> <utility> <vector>)

# Compiles the sources of a target in batches.
#   crossfield_batch_sources(TARGET [SIZE])
function (crossfield_batch_sources target)
  set(size "${CROSSFIELD_BATCH_SIZE}")
  if (ARGC GREATER 1)
    set(size "${ARGV1}")
  endif ()
  if (CROSSFIELD_FAST_COMPILE AND TARGET ${target})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE "${size}")
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ takes the sources of a batch for headers, where unnamed namespaces would be suspicious.
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif ()
  endif ()
endfunction ()

# Precompiles headers for a target, as target_precompile_headers does.
#   crossfield_precompile_headers(TARGET HEADER...)
#   crossfield_precompile_headers(TARGET REUSE_FROM OTHER)   OTHER has the same compiler options
function (crossfield_precompile_headers target)
  if (NOT CROSSFIELD_FAST_COMPILE)
    return ()
  endif ()
  if (ARGV1 STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else ()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif ()
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess) # for ccache
  endif ()
endfunction ()

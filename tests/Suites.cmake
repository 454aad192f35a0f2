# Cases of tests, grouped for ctest. CMake includes this file for the Python tests, ctest for the programs of googletest.

cmake_minimum_required(VERSION 3.22) # ctest begins with the policies of 2.8

file(GLOB lists "${CMAKE_CURRENT_LIST_DIR}/left_out/*.txt")
set(own_patterns "")
foreach (list IN ITEMS "${CMAKE_CURRENT_LIST_DIR}/own_tests.txt" ${lists})
  file(STRINGS "${list}" lines REGEX "^[^#]")
  list(APPEND own_patterns ${lines})
endforeach ()

# Sets RESULT to whether a case is a test of its own: a pattern matches the case, but not its whole suite.
function (crossfield_is_own_test result suite case)
  set(${result} OFF PARENT_SCOPE)
  foreach (pattern IN LISTS own_patterns)
    if ("${suite}.${case}" MATCHES "${pattern}" AND NOT "${suite}" MATCHES "${pattern}")
      set(${result} ON PARENT_SCOPE)
      return ()
    endif ()
  endforeach ()
endfunction ()

# Adds one test PREFIX.SUITE for each suite of a program of googletest, and one PREFIX.SUITE.CASE for each case that is a test of its
# own. ctest calls this function, so that the tests are those of the program that it runs.
function (crossfield_add_suites_of program prefix)
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    add_test(${prefix}.NotBuilt "${program}") # ctest reports that the program is missing or fails
    return ()
  endif ()
  string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}") # values of parameters
  string(REGEX MATCHALL "[^\n]+" lines "${listed}")
  foreach (line IN LISTS lines)
    if (line MATCHES "^([^ ]+)\\.$")
      set(suite "${CMAKE_MATCH_1}")
    elseif (line MATCHES "^  (.+)$")
      set(case "${CMAKE_MATCH_1}")
      crossfield_is_own_test(is_own "${prefix}.${suite}" "${case}")
      if (is_own)
        list(APPEND own "${suite}.${case}")
        string(APPEND not_${suite} ":${suite}.${case}")
      else ()
        list(APPEND shared "${suite}")
      endif ()
    endif ()
  endforeach ()
  list(REMOVE_DUPLICATES shared)
  foreach (name IN LISTS own shared)
    set(filter "${name}")
    if (name IN_LIST shared)
      string(REGEX REPLACE "^:" "-" without "${not_${name}}")
      set(filter "${name}.*${without}")
    endif ()
    add_test(${prefix}.${name} "${program}" "--gtest_filter=${filter}")
    set_tests_properties(${prefix}.${name} PROPERTIES SKIP_RETURN_CODE 77 ${ARGN})
  endforeach ()
endfunction ()

# Builds the C++ example of README.md in a folder of its own and runs it, against the build tree (TREE is Build), or
# against an installed tree that was moved (Installed), whose program and Python package run as well:
#   cmake -D TREE=… -D GENERATOR=… -D BUILD=… -D EXAMPLE=… -D FOLDER=… -D PYTHON=… -D KEPT=… -P consumer.cmake
function (run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY "${FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
endfunction ()
file(REMOVE_RECURSE "${FOLDER}")
file(COPY "${EXAMPLE}" DESTINATION "${FOLDER}")
set(tree "${BUILD}")
if (TREE STREQUAL Installed)
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${FOLDER}/first"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(tree "${FOLDER}/moved")
  file(RENAME "${FOLDER}/first" "${tree}")
endif ()
run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S example -B out "-DCMAKE_PREFIX_PATH=${tree}" ${VTK_DIR_OPTION})
run("${CMAKE_COMMAND}" --build out)
run("${PYTHON}" "${KEPT}" "${FOLDER}" -- "${FOLDER}/out/example")
if (NOT EXISTS "${FOLDER}/quads.vtu")
  message(FATAL_ERROR "The example has not written quads.vtu.")
endif ()
if (TREE STREQUAL Build)
  run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S example -B out "-DCrossField_DIR=${BUILD}") # some users name the build tree so
  return ()
endif ()
run("${tree}/bin/crossfield" check builtin:square)
execute_process(COMMAND "${tree}/bin/crossfield" --paths
  OUTPUT_VARIABLE paths COMMAND_ERROR_IS_FATAL ANY)
if (NOT paths MATCHES "python: (${tree}/[^\n]*)")
  message(FATAL_ERROR "`crossfield --paths` of the installed program names folders outside the installed tree:\n${paths}")
endif ()
set(ENV{PYTHONPATH} "${CMAKE_MATCH_1}")
run("${PYTHON}" -c "import crossfield; print(crossfield.solve('builtin:disk', [(0, 0, 4, 0.2)]).report['converged'])")

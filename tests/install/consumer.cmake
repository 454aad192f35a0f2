# Installs the build, moves the installed tree, builds a program against it and runs both programs:
#   cmake -D BUILD=… -D FOLDER=… -D PYTHON=… -P consumer.cmake
function (run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${FOLDER}/first"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${FOLDER}/first" "${FOLDER}/moved")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/consumer" -B "${FOLDER}/consumer"
  "-DCMAKE_PREFIX_PATH=${FOLDER}/moved" -DCMAKE_BUILD_TYPE=Release ${VTK_DIR_OPTION})
run("${CMAKE_COMMAND}" --build "${FOLDER}/consumer")
run("${FOLDER}/consumer/consumer")
run("${FOLDER}/moved/bin/crossfield" check builtin:square)
execute_process(COMMAND "${FOLDER}/moved/bin/crossfield" --paths
  OUTPUT_VARIABLE paths COMMAND_ERROR_IS_FATAL ANY)
if (NOT paths MATCHES "python: (${FOLDER}/moved/[^\n]*)")
  message(FATAL_ERROR "`crossfield --paths` of the installed program names folders outside the installed tree:\n${paths}")
endif ()
set(ENV{PYTHONPATH} "${CMAKE_MATCH_1}")
run("${PYTHON}" -c "import crossfield; print(crossfield.solve('builtin:disk', [(0, 0, 4, 0.2)]).report['converged'])")

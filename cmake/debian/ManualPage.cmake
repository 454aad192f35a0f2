# Called by cpack when the files of the package are in their folder, before it writes the package.
set(root "${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}")
set(folder "${root}/share/man/man1")
file(MAKE_DIRECTORY "${folder}")
execute_process(COMMAND bash "${CMAKE_CURRENT_LIST_DIR}/manual_page.sh" "${root}/bin/crossfield"
  OUTPUT_FILE "${folder}/crossfield.1" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND gzip -9nf "${folder}/crossfield.1" COMMAND_ERROR_IS_FATAL ANY)

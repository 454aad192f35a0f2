# Creates an empty folder for the files that the tests of this run write.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

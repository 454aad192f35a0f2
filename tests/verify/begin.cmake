# An empty folder for what the tests of this run write: nothing of an earlier run is left in it.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

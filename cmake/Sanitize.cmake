# Compiler and linker options of a build with CROSSFIELD_SANITIZE. One build serves tests, coverage and
# fuzzing.
if (NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR
    "CROSSFIELD_SANITIZE needs libFuzzer, which only clang has. Configure with: cmake --preset checked")
endif ()
add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
  "-fsanitize-ignorelist=${CMAKE_SOURCE_DIR}/tests/checked/ignored.txt")
# With large address randomisation (vm.mmap_rnd_bits = 32) a position-independent program may overlap
# the memory of the sanitizer and abort at start.
add_link_options(-fsanitize=address,undefined -no-pie --coverage)
# Options of the code whose coverage is measured, and of the code that fuzzers explore.
# Functions of libraries in headers are not counted: with them, tests take twice as long.
set(CROSSFIELD_COVERAGE_OPTIONS --coverage "-fprofile-exclude-files=/usr/.*")
set(CROSSFIELD_FUZZER_OPTIONS -fsanitize=fuzzer-no-link
  "-fsanitize-coverage-ignorelist=${CMAKE_SOURCE_DIR}/tests/checked/not_counted.txt")

# Source with the options of the sanitizers at run time; every executable has it.
set(CROSSFIELD_SANITIZER_SOURCE "${CMAKE_SOURCE_DIR}/tests/checked/SanitizerOptions.cxx")

# Compiler and linker options of a build with CROSSFIELD_SANITIZE. The guide of the fuzzers is compiled
# in, too, so that one build serves tests, coverage and fuzzing.
if (NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR
    "CROSSFIELD_SANITIZE needs clang, which has libFuzzer; use the preset `checked`.")
endif ()
add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
  "-fsanitize-ignorelist=${CMAKE_SOURCE_DIR}/tests/checked/ignored.txt")
# Where the kernel moves programs far (vm.mmap_rnd_bits = 32), one that has no address of its own may
# come to lie on the sanitizer's memory, and ends before it begins.
add_link_options(-fsanitize=address,undefined -no-pie --coverage)
# Of what is measured, and of what the fuzzers look into.
set(CROSSFIELD_COVERAGE_OPTIONS --coverage)
set(CROSSFIELD_FUZZER_OPTIONS -fsanitize=fuzzer-no-link)

# Every executable has this source, which holds the options at run time.
set(CROSSFIELD_SANITIZER_SOURCE "${CMAKE_SOURCE_DIR}/tests/checked/SanitizerOptions.cxx")

/**
 * Default options of the sanitizers for every program of a build with CROSSFIELD_SANITIZE. The
 * sanitizers call these functions; the environment variables ASAN_OPTIONS and UBSAN_OPTIONS add to
 * these options.
 */
extern "C"
{
  const char* __asan_default_options();
  const char* __ubsan_default_options();
  const char* __lsan_default_options();
  const char* __lsan_default_suppressions();

  const char* __asan_default_options()
  {
    // A report ends the program by a signal, which differs from every exit status of the program.
    return "abort_on_error=1:strict_string_checks=1:allocator_may_return_null=0";
  }

  const char* __ubsan_default_options()
  {
    return "print_stacktrace=1:abort_on_error=1";
  }

  const char* __lsan_default_options()
  {
    return "print_suppressions=0"; // tests read what the program prints
  }

  const char* __lsan_default_suppressions()
  {
    // LLVM's OpenMP does not release what it allocates for threads of TBB that call CHOLMOD.
    return "leak:libomp.so";
  }
}

/**
 * Options of the sanitizers for every program of a build with CROSSFIELD_SANITIZE, however it is
 * started. The sanitizers call these functions; environment variables of their names add to them.
 */
extern "C"
{
  const char* __asan_default_options();
  const char* __ubsan_default_options();
  const char* __lsan_default_suppressions();

  const char* __asan_default_options()
  {
    // A report ends in a signal: no exit status of the program can be mistaken for it.
    return "abort_on_error=1:strict_string_checks=1:allocator_may_return_null=0";
  }

  const char* __ubsan_default_options()
  {
    return "print_stacktrace=1:abort_on_error=1";
  }

  const char* __lsan_default_suppressions()
  {
    return "";
  }
}

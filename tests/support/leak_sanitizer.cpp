// glibc never frees the list of folders that it makes of LOCPATH, which the tests of locales set.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:argz_\n"; }

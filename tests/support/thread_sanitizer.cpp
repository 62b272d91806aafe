// oneTBB and Embree are not instrumented: the thread sanitizer sees what they read and free, but not how their threads
// hand it over. Code that must be seen to share nothing runs on ThreadExecutor instead, see thread_executor.h.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() { return "race:libtbb.so\nrace:libembree\n"; }

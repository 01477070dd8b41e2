// The library of WASI has no threads, so it lacks what thread_local objects with a destructor need.
// The only thread lives as long as the page: nothing is destroyed.

extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) {
  return 0;
}

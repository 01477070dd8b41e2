// Loaded into the window for a search for leaks. Mesa's GLX driver leaks 240 bytes when it is
// unloaded, which then have no owner. This keeps the driver loaded, so that it still holds them.

extern "C" int dlclose(void*) {
  return 0;
}

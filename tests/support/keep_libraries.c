/* To be preloaded under AddressSanitizer: keeps libraries loaded. Otherwise, memory that OpenGL drivers keep in
   static variables would be reported as leaked after unloading, without a name for suppressions. */
int dlclose(void* library) {
  (void)library;
  return 0;
}

// Emscripten 3.1.6 declares getrandom and has getentropy alone.
#include <stddef.h>
#include <unistd.h>

#include <sys/random.h>

ssize_t getrandom(void* bytes, size_t count, unsigned flags) {
  (void)flags;
  return getentropy(bytes, count) == 0 ? (ssize_t)count : -1;
}

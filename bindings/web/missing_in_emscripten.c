// Functions that emscripten 3.1.6 declares but does not define.
#include <errno.h>
#include <spawn.h>
#include <stddef.h>
#include <unistd.h>

#include <sys/random.h>

// It only has getentropy.
ssize_t getrandom(void* bytes, size_t count, unsigned flags) {
  (void)flags;
  return getentropy(bytes, count) == 0 ? (ssize_t)count : -1;
}

// There are no other programs to run.
int posix_spawnp(pid_t* restrict id, const char* restrict program,
                 const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* restrict attributes, char* const* restrict words,
                 char* const* restrict environment) {
  (void)id, (void)program, (void)actions, (void)attributes, (void)words, (void)environment;
  return ENOSYS;
}

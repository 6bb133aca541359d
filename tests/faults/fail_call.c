// Preloaded into a program: makes the Nth call of a kind fail, like a full disk, lack of memory
// or a system limit.
//
//   FAIL_CALL=KIND:N    only the Nth call; KIND:N+ for all calls from the Nth
//   FAIL_COUNT=FILE     nothing fails; the number of calls is written to FILE
//   FAIL_TRACE=1        prints where the first failure is
//
// KIND is memory, read, write, open, sync, rename or thread.

// NOLINTBEGIN(bugprone-reserved-identifier): names of the C library
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);
// NOLINTEND(bugprone-reserved-identifier)

static atomic_long calls;
static const char* kind;
static size_t kind_length;
static long first;
static int all;
static const char* count_file;
static int trace;

__attribute__((constructor)) static void start(void) {
  const char* const what = getenv("FAIL_CALL");
  const char* const colon = what == NULL ? NULL : strchr(what, ':');
  count_file = getenv("FAIL_COUNT");
  trace = getenv("FAIL_TRACE") != NULL;
  if (colon != NULL) {
    char* end = NULL;
    first = strtol(colon + 1, &end, 10);
    all = *end == '+';
    kind_length = (size_t)(colon - what);
    kind = what;
  }
}

__attribute__((destructor)) static void finish(void) {
  kind = NULL;
  FILE* const file = count_file == NULL ? NULL : fopen(count_file, "w");
  if (file != NULL) {
    fprintf(file, "%ld\n", atomic_load(&calls));
    fclose(file);
  }
}

static void show_place(void) {
  void* frames[40];
  kind = NULL;
  backtrace_symbols_fd(frames, backtrace(frames, 40), STDERR_FILENO);
}

static int fails(const char* name, int error) {
  if (kind == NULL || strlen(name) != kind_length || strncmp(name, kind, kind_length) != 0) {
    return 0;
  }
  const long number = atomic_fetch_add(&calls, 1) + 1;
  if (count_file != NULL || number < first || (number > first && !all)) {
    return 0;
  }
  if (trace && number == first) {
    const char* const old = kind;
    show_place();
    kind = old;
  }
  errno = error;
  return 1;
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

void* malloc(size_t size) {
  return fails("memory", ENOMEM) ? NULL : __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  return fails("memory", ENOMEM) ? NULL : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
  return fails("memory", ENOMEM) ? NULL : __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return fails("memory", ENOMEM) ? NULL : __libc_memalign(alignment, size);
}
void* memalign(size_t alignment, size_t size) {
  return fails("memory", ENOMEM) ? NULL : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, size_t alignment, size_t size) {
  *result = fails("memory", ENOMEM) ? NULL : __libc_memalign(alignment, size);
  return *result == NULL ? ENOMEM : 0;
}

ssize_t write(int file, const void* bytes, size_t size) {
  return file > 2 && fails("write", ENOSPC) ? -1 : NEXT(write)(file, bytes, size);
}
ssize_t read(int file, void* bytes, size_t size) {
  return file > 2 && fails("read", EIO) ? -1 : NEXT(read)(file, bytes, size);
}
int fsync(int file) {
  return fails("sync", EIO) ? -1 : NEXT(fsync)(file);
}
int rename(const char* from, const char* to) {
  return fails("rename", EXDEV) ? -1 : NEXT(rename)(from, to);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*body)(void*),
                   void* argument) {
  return fails("thread", EAGAIN) ? EAGAIN
                                 : NEXT(pthread_create)(thread, attributes, body, argument);
}

int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  return fails("open", EMFILE) ? -1 : NEXT(open)(path, flags, mode);
}
int open64(const char* path, int flags, ...) __attribute__((alias("open")));

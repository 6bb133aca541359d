// Handles exceptions that cannot be caught: thrown before main by the constructors of a shared
// library (which can run out of memory), or on a library's thread. The program still ends with an
// exit status.

#include <unistd.h>

#include <exception>
#include <new>
#include <string_view>

namespace {

void write_text(std::string_view text) {
  // A failed write cannot be reported anywhere.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

[[noreturn]] void end_process() {
  try {
    if (std::current_exception() != nullptr) {
      throw;
    }
    write_text("scenefile: ended by the system\n");
  } catch (const std::bad_alloc&) {
    write_text("scenefile: out of memory while starting or in a thread\n");
  } catch (const std::exception& error) {
    write_text("scenefile: ");
    write_text(error.what());
    write_text("\n");
  } catch (...) {
    write_text("scenefile: ended by an unknown exception\n");
  }
  ::_exit(3);
}

void install() {
  std::set_terminate(end_process);
}

// This section runs before the constructors of shared libraries. Sanitizers also start there, and
// none of our code may run before them.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
__attribute__((section(".preinit_array"), used)) void (*const preinit)() = install;
#else
[[maybe_unused]] const bool installed = (install(), true);
#endif

}  // namespace

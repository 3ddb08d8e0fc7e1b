/// A library that is preloaded into a program under test, and ends the program by SIGKILL at one of
/// its calls that change files.
///
/// KILL_FOLDER names the folder whose files count, KILL_AT is the number of the call, from 1. A
/// write that is hit has written half of its bytes. With KILL_COUNT instead, the library writes the
/// number of calls to the file of that name after each call. A test can thus end a program at every
/// moment at which a file can be half written, without chance and without a debugger.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> calls{0};
thread_local bool within = false;  ///< True during the calls that this file itself makes, which do
                                   ///< not count.

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool is_watched(const char* path) {
  const char* const folder = std::getenv("KILL_FOLDER");
  return folder != nullptr && path != nullptr &&
         std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_watched(int file) {
  std::array<char, 64> link{};
  std::array<char, 4096> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  return ::readlink(link.data(), path.data(), path.size() - 1) > 0 && is_watched(path.data());
}

void write_count(const char* name, long count) {
  const int file = ::open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  std::array<char, 32> text{};
  const int size = std::snprintf(text.data(), text.size(), "%ld", count);
  static_cast<void>(next<::ssize_t (*)(int, const void*, std::size_t)>("write")(
      file, text.data(), static_cast<std::size_t>(size)));
  ::close(file);
}

/// Returns true if the program must end at this call. The caller ends it after its own actions.
bool is_last() {
  const long number = ++calls;
  if (const char* const name = std::getenv("KILL_COUNT")) write_count(name, number);
  const char* const at = std::getenv("KILL_AT");
  return at != nullptr && std::atol(at) == number;
}

void end() {
  ::kill(::getpid(), SIGKILL);
  for (;;) ::pause();
}

template <typename Watched>
bool hits(Watched watched) {
  if (within) return false;
  within = true;
  const bool last = is_watched(watched) && is_last();
  within = false;
  return last;
}

}  // namespace

extern "C" {

::ssize_t write(int file, const void* bytes, std::size_t size) {
  const auto real = next<::ssize_t (*)(int, const void*, std::size_t)>("write");
  if (!hits(file)) return real(file, bytes, size);
  static_cast<void>(real(file, bytes, size / 2));
  end();
  return -1;
}

::ssize_t pwrite64(int file, const void* bytes, std::size_t size, ::off64_t at) {
  using Real = ::ssize_t (*)(int, const void*, std::size_t, ::off64_t);
  const auto real = next<Real>("pwrite64");
  if (!hits(file)) return real(file, bytes, size, at);
  static_cast<void>(real(file, bytes, size / 2, at));
  end();
  return -1;
}

int fsync(int file) {
  if (hits(file)) end();
  return next<int (*)(int)>("fsync")(file);
}

int fdatasync(int file) {
  if (hits(file)) end();
  return next<int (*)(int)>("fdatasync")(file);
}

int ftruncate64(int file, ::off64_t size) noexcept {
  if (hits(file)) end();
  return next<int (*)(int, ::off64_t)>("ftruncate64")(file, size);
}

int rename(const char* from, const char* to) noexcept {
  if (hits(to)) end();
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}

int unlink(const char* path) noexcept {
  if (hits(path)) end();
  return next<int (*)(const char*)>("unlink")(path);
}
}

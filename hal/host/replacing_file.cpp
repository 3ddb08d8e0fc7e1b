#include "hal/host/replacing_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "hal/host/system_call.hpp"

namespace hal::host {
namespace {

/// Name of a file that is being written, stored in a form that a signal handler can read.
struct Unfinished {
  std::atomic<bool> taken{false};
  std::atomic<bool> named{false};
  std::array<char, 4096> name{};
};
// The array has more entries than the number of files that a command writes at the same time. A
// file for which no entry is free is still written, but a signal does not remove it.
std::array<Unfinished, 16> unfinished;

void keep_name(const std::string& name) {
  for (Unfinished& slot : unfinished) {
    if (name.size() >= slot.name.size() || slot.taken.exchange(true)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.named = true;
    return;
  }
}

void forget_name(const std::string& name) {
  for (Unfinished& slot : unfinished) {
    if (!slot.named || name != slot.name.data()) continue;
    slot.named = false;
    slot.taken = false;
  }
}

/// Signals with which a user ends a command.
constexpr std::array kEndingSignals{SIGINT, SIGTERM, SIGHUP};

/// Blocks kEndingSignals in this thread while the object exists. A signal thus cannot come between
/// the creation of a file and the registration of its name.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    ::sigset_t ending{};
    static_cast<void>(::sigemptyset(&ending));
    for (const int signal : kEndingSignals) static_cast<void>(::sigaddset(&ending, signal));
    static_cast<void>(::pthread_sigmask(SIG_BLOCK, &ending, &before_));
  }
  ~SignalsHeldBack() { static_cast<void>(::pthread_sigmask(SIG_SETMASK, &before_, nullptr)); }
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  ::sigset_t before_{};
};

void remove_and_end(int signal) {
  for (const Unfinished& slot : unfinished) {
    if (slot.named) static_cast<void>(::unlink(slot.name.data()));
  }
  static_cast<void>(std::signal(signal, SIG_DFL));
  static_cast<void>(::raise(signal));
}

/// Returns the number of the process's open descriptor that `path` names; nothing if `path` names
/// no descriptor.
std::optional<int> own_stream(std::string_view path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec == std::errc{} && read.ptr == digits.data() + digits.size()) return number;
  }
  return std::nullopt;
}

/// Opens a device or a pipe for writing. Waits a limited time for the reader of a pipe, because
/// during an endless wait the program would seem to hang. On failure returns -1 and sets errno, to
/// ENXIO if there is no reader.
int open_with_reader(const std::string& target) {
  constexpr int kPeriodMs = 20;
  constexpr int kMaxTries = 5000 / kPeriodMs;
  constexpr int kMode = O_WRONLY | O_CLOEXEC | O_NOCTTY;
  for (int i = 0;; ++i) {
    const int file = open_file(target, kMode | O_NONBLOCK);
    if (file >= 0) {
      const int flags = control_file(file, F_GETFL);
      if (control_file(file, F_SETFL, flags & ~O_NONBLOCK) != 0) errno = 0;
      return file;
    }
    if (errno != ENXIO || i >= kMaxTries) return -1;
    static_cast<void>(::poll(nullptr, 0, kPeriodMs));
  }
}

}  // namespace

std::string without_links(const std::string& path) {
  constexpr int kMaxLinks = 40;  // Linux follows at most 40 links.
  std::filesystem::path followed{path};
  for (int links = 0; links < kMaxLinks; ++links) {
    std::error_code is_none;
    const std::filesystem::path next = std::filesystem::read_symlink(followed, is_none);
    if (is_none) return followed.string();
    followed = followed.parent_path() / next;  // If `next` is absolute, the result is `next` alone.
  }
  throw std::system_error{ELOOP, std::generic_category(), path};
}

ReplacingFile::ReplacingFile(std::string path) : path_{std::move(path)}, target_{path_} {
  if (own_stream(path_)) {
    open_in_place();
    return;
  }
  target_ = without_links(path_);
  struct ::stat found {};
  const bool exists = ::stat(target_.c_str(), &found) == 0;
  if (!exists && errno != ENOENT) fail("cannot create");
  if (exists && !S_ISREG(found.st_mode)) {
    open_in_place();
    return;
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail("cannot write");
  replaces_ = exists;
  open_beside();
}

ReplacingFile::~ReplacingFile() {
  if (!committed_ && !beside_.empty()) {
    static_cast<void>(::unlink(beside_.c_str()));
    forget_name(beside_);
  }
  if (descriptor_ >= 0) static_cast<void>(::close(descriptor_));
}

void ReplacingFile::open_in_place() {
  const auto own = own_stream(path_);
  descriptor_ = own ? control_file(*own, F_DUPFD_CLOEXEC) : open_with_reader(target_);
  if (descriptor_ < 0) fail(errno == ENXIO ? "nothing reads the pipe" : "cannot write");
}

void ReplacingFile::open_beside() {
  static std::atomic<unsigned> count{0};
  // Killed processes with the same process number may have left files, so several names are tried.
  constexpr int kMaxNames = 1000;
  const std::string folder = std::filesystem::path{target_}.parent_path().string();
  const SignalsHeldBack held_back;
  for (int i = 0; i < kMaxNames; ++i) {
    std::string beside = folder.empty() ? folder : folder + "/";
    beside.append(".kerfline-").append(std::to_string(::getpid()));
    beside.append("-").append(std::to_string(count++)).append(".part");
    descriptor_ = open_file(beside, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) fail("cannot create");
    beside_ = std::move(beside);
    keep_name(beside_);
    if (replaces_) take_mode_of_target();
    return;
  }
  fail("cannot create");
}

/// Gives the new file the owner and the mode of the old file, so that the same users may read it.
void ReplacingFile::take_mode_of_target() {
  struct ::stat old {};
  if (::stat(target_.c_str(), &old) != 0) return;
  // Only root may change the owner. The mode is set after the owner, because a change of owner
  // clears bits of the mode.
  if (::fchown(descriptor_, old.st_uid, old.st_gid) != 0) errno = 0;
  if (::fchmod(descriptor_, old.st_mode & 0777) != 0) errno = 0;
}

void ReplacingFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot write");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void ReplacingFile::commit() {
  if (committed_) return;
  if (!beside_.empty()) {
    if (replaces_ && ::fsync(descriptor_) != 0) fail("cannot write");
    if (std::rename(beside_.c_str(), target_.c_str()) != 0) fail("cannot replace");
    forget_name(beside_);
  }
  committed_ = true;
}

bool ReplacingFile::commit_as_new() {
  if (beside_.empty() || replaces_) return false;
  if (::fsync(descriptor_) != 0) fail("cannot write");
  if (::renameat2(AT_FDCWD, beside_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST) return false;
    if (errno != EINVAL && errno != ENOSYS) fail("cannot create");
    // This file system cannot refuse to rename over an existing file. So a file that another
    // process has just created is replaced here.
    if (std::rename(beside_.c_str(), target_.c_str()) != 0) fail("cannot create");
  }
  forget_name(beside_);
  committed_ = true;
  return true;
}

void ReplacingFile::fail(const char* action) const {
  throw std::system_error{errno, std::generic_category(), std::string{action} + " " + path_};
}

void ReplacingFile::remove_unfinished_on_signals() {
  for (const int signal : kEndingSignals) {
    struct ::sigaction old {};
    if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_DFL) continue;
    static_cast<void>(std::signal(signal, remove_and_end));
  }
}

}  // namespace hal::host

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace hal::host {

/// A file that is written next to its target and replaces the target once it is whole.
///
/// Until commit() the target stays unchanged: a full disk, an error, a signal or a kill loses the
/// new file only. If the path is a symbolic link, the link stays and the file that it leads to is
/// replaced. Devices, pipes and the process's own streams (`/dev/stdout`) cannot be replaced by a
/// file: they are written directly.
/// Every failure of the file system is reported as a std::system_error whose text names the target.
class ReplacingFile {
 public:
  /// Creates the new file next to `path`. Throws if no file can be written at `path`: it is a
  /// folder, it is write-protected, or its folder does not exist.
  explicit ReplacingFile(std::string path);
  /// Removes the new file unless it was committed.
  ~ReplacingFile();
  ReplacingFile(const ReplacingFile&) = delete;
  ReplacingFile& operator=(const ReplacingFile&) = delete;

  void write(std::string_view bytes);

  /// Completes the file. If a file is to be replaced, first waits until the disk has the bytes,
  /// then renames the new file to the target. A second call does nothing.
  void commit();

  /// Like commit(), for a target that does not exist yet. Returns false if the target has come into
  /// existence meanwhile; the target then stays unchanged.
  [[nodiscard]] bool commit_as_new();

  /// Returns the descriptor of the open file, for locks. It is valid after commit(), too.
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// From now on removes this process's unfinished files when SIGINT, SIGTERM or SIGHUP ends it,
  /// unless the process handles or ignores these signals itself. To be called once, at the start of
  /// the process.
  static void remove_unfinished_on_signals();

 private:
  void open_in_place();
  void open_beside();
  void take_mode_of_target();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string target_;  ///< `path_` with its symbolic links followed.
  std::string beside_;  ///< Path of the new file; empty if the target is written directly.
  int descriptor_ = -1;
  bool replaces_ = false;  ///< The target exists already.
  bool committed_ = false;
};

/// Returns `path` with the symbolic links of its last part followed, even if they lead to no file.
/// Throws std::system_error if the links never end.
[[nodiscard]] std::string without_links(const std::string& path);

}  // namespace hal::host

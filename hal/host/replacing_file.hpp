#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace hal::host {

/// A file that is written next to its target and replaces the target when it is complete.
///
/// Until commit() the target stays unchanged: after a full disk, an error, a signal or a kill, only
/// the new file is lost. If the path is a symbolic link, the link stays, and the file to which it
/// leads is replaced. Devices, pipes and the process's own streams (`/dev/stdout`) cannot be
/// replaced by a file, so they are written directly. Every failure of the file system is reported
/// as a std::system_error whose text names the target.
class ReplacingFile {
 public:
  /// Creates the new file next to `path`. Throws if no file can be written at `path`, because it is
  /// a folder, it is write-protected, or its folder does not exist.
  explicit ReplacingFile(std::string path);
  /// Removes the new file unless it was committed.
  ~ReplacingFile();
  ReplacingFile(const ReplacingFile&) = delete;
  ReplacingFile& operator=(const ReplacingFile&) = delete;

  void write(std::string_view bytes);

  /// Completes the file. If it replaces a file, first waits until the disk has stored the new
  /// bytes. Then renames the new file to the target. A second call does nothing.
  void commit();

  /// Completes the file like commit(), for a target that does not exist yet. Returns false and
  /// leaves the target unchanged if another process has created the target meanwhile.
  [[nodiscard]] bool commit_as_new();

  /// Returns the descriptor of the open file, which serves for locks. It is still valid after
  /// commit().
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// From now on, SIGINT, SIGTERM and SIGHUP remove this process's unfinished files before they end
  /// the process. Signals that the process already handles or ignores are not changed. Called once,
  /// at the start of the process.
  static void remove_unfinished_on_signals();

 private:
  void open_in_place();
  void open_beside();
  void take_mode_of_target();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string target_;  ///< `path_` after following its symbolic links.
  std::string beside_;  ///< Path of the new file; empty if the target is written directly.
  int descriptor_ = -1;
  bool replaces_ = false;  ///< Whether the target existed when this object was created.
  bool committed_ = false;
};

/// Returns `path` after following the symbolic links of its last part, even if they lead to no
/// file. Throws std::system_error if the links form a loop.
[[nodiscard]] std::string without_links(const std::string& path);

}  // namespace hal::host

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace hal::host {

/// A file that is written beside its target and takes the target's place once it is whole.
///
/// Until commit() the target stays as it was: a full disk, an error, a signal or a kill cost the
/// new file only. A symbolic link stays a link, and the file behind it is replaced. Devices, pipes
/// and the process's own streams (`/dev/stdout`) have no place that another file could take: these
/// are written directly.
/// Every failure of the file system is a std::system_error whose text names the target.
class ReplacingFile {
 public:
  /// Creates the file beside `path`. Throws where no file can be there: a folder, a file that is
  /// write-protected, a folder that does not exist.
  explicit ReplacingFile(std::string path);
  /// Removes what was not committed.
  ~ReplacingFile();
  ReplacingFile(const ReplacingFile&) = delete;
  ReplacingFile& operator=(const ReplacingFile&) = delete;

  void write(std::string_view bytes);

  /// Waits until the disk has the bytes if a file is to be replaced, and takes its place. A second
  /// call does nothing.
  void commit();

  /// The same where nothing has the name yet. False where something has got it since: the target
  /// stays as it is.
  [[nodiscard]] bool commit_as_new();

  /// The open file, also after commit(); for locks.
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Removes the files of this process that are not whole when SIGINT, SIGTERM or SIGHUP ends it,
  /// unless it handles or ignores these itself. To be called once, at its start.
  static void remove_unfinished_on_signals();

 private:
  void open_in_place();
  void open_beside();
  void take_mode_of_target();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string target_;  ///< `path_` with its links followed.
  std::string beside_;  ///< Empty where the target is written directly.
  int descriptor_ = -1;
  bool replaces_ = false;  ///< There is a file already.
  bool committed_ = false;
};

/// `path` with the symbolic links of its last part followed, also where they lead to no file.
/// Throws std::system_error for links without end.
[[nodiscard]] std::string without_links(const std::string& path);

}  // namespace hal::host

#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "hal/host/replacing_file.hpp"

namespace sim {

/// A file that is written through one large buffer. Until `close()` the text goes to a temporary
/// file next to the target.
///
/// Every failure of the file system is a std::system_error whose text names the file. Text reaches
/// the disk when the buffer is full, at `drain()` and at `close()`. If the object is destroyed
/// without `close()` (by an exception), the target stays unchanged.
class OutputFile {
 public:
  /// Opens the temporary file. Throws if no file can be written at `path`; does not touch an
  /// existing file.
  explicit OutputFile(std::string path);

  /// Returns the buffer to which the caller formats; the caller calls `drain_when_full()` now and
  /// then.
  [[nodiscard]] fmt::memory_buffer& buffer() { return buffer_; }

  void drain_when_full() {
    if (buffer_.size() >= kDrainAt) drain();
  }

  /// Writes the buffer to the temporary file next to the target; that file remains if the process
  /// is killed.
  void drain();
  /// Writes the rest and replaces the target; a second call does nothing.
  void close();

 private:
  /// Size of the buffer in bytes, so large that system calls do not show in a profile.
  static constexpr std::size_t kDrainAt = std::size_t{1} << 18;

  hal::host::ReplacingFile file_;
  fmt::memory_buffer buffer_;
};

/// Creates the file `path` with `content`, or replaces it. Throws std::system_error naming it.
void write_file(const std::string& path, std::string_view content);

}  // namespace sim

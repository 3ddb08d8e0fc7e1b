#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "hal/host/replacing_file.hpp"

namespace sim {

/// A file that is written through one large buffer. Until close(), the text goes to a temporary
/// file next to the target.
///
/// Every failure of the file system throws a std::system_error whose text names the file. Text
/// reaches the disk when the buffer is full, at drain() and at close(). If the object is destroyed
/// without close() (by an exception), the target stays unchanged.
class OutputFile {
 public:
  /// Opens the temporary file. Throws if no file can be written at `path`. Does not change an
  /// existing file at `path`.
  explicit OutputFile(std::string path);

  /// Returns the buffer to which the caller formats. The caller must call drain_when_full()
  /// regularly.
  [[nodiscard]] fmt::memory_buffer& buffer() { return buffer_; }

  void drain_when_full() {
    if (buffer_.size() >= kDrainAt) drain();
  }

  /// Writes the buffer to the temporary file next to the target. If the process is killed, the
  /// temporary file remains.
  void drain();
  /// Writes the rest and replaces the target. A second call has no effect.
  void close();

 private:
  /// Fill level at which the buffer is written, bytes; so large that the cost of system calls is
  /// negligible.
  static constexpr std::size_t kDrainAt = std::size_t{1} << 18;

  hal::host::ReplacingFile file_;
  fmt::memory_buffer buffer_;
};

/// Creates the file `path` with `content`, or replaces it. Throws std::system_error with the name
/// of the file.
void write_file(const std::string& path, std::string_view content);

}  // namespace sim

#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "hal/host/replacing_file.hpp"

namespace sim {

/// A file being written through one large buffer, beside its target until `close()`.
///
/// Every failure of the file system is a std::system_error whose text names the
/// file. Text reaches the disk when the buffer is full, at `drain()` and at `close()`;
/// destroyed without `close()` (an exception is under way), the target stays as it was.
class OutputFile {
 public:
  /// Throws where no file can be written there; an existing one is not touched.
  explicit OutputFile(std::string path);

  /// Where the owner formats to; call `drain_when_full()` now and then.
  [[nodiscard]] fmt::memory_buffer& buffer() { return buffer_; }

  void drain_when_full() {
    if (buffer_.size() >= kDrainAt) drain();
  }

  /// Writes what is in the buffer to the file beside the target: a killed process leaves that much.
  void drain();
  /// Writes what is left and takes the place of the target; a second call does nothing.
  void close();

 private:
  /// Large enough that the calls of the system do not show in a profile.
  static constexpr std::size_t kDrainAt = std::size_t{1} << 18;

  hal::host::ReplacingFile file_;
  fmt::memory_buffer buffer_;
};

/// Creates the file `path` with `content`, or replaces it. Throws std::system_error naming it.
void write_file(const std::string& path, std::string_view content);

}  // namespace sim

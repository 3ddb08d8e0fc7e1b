#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace sim {

/// A file being written through one large buffer.
///
/// Every failure of the file system is a std::system_error whose text names the
/// file. Text reaches the disk when the buffer is full and at `close()`;
/// destroyed without `close()` (an exception is under way), the file gets what
/// was formatted so far and errors are swallowed.
class OutputFile {
 public:
  /// Creates or empties the file.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where the owner formats to; call `drain_when_full()` now and then.
  [[nodiscard]] fmt::memory_buffer& buffer() { return buffer_; }

  void drain_when_full() {
    if (buffer_.size() >= kDrainAt) drain();
  }

  /// Writes what is left and closes; a second call does nothing.
  void close();

 private:
  /// Large enough that the calls of the system do not show in a profile.
  static constexpr std::size_t kDrainAt = std::size_t{1} << 18;
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void drain();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  fmt::memory_buffer buffer_;
};

/// Creates the file `path` with `content`. Throws std::system_error naming it.
void write_file(const std::string& path, std::string_view content);

}  // namespace sim

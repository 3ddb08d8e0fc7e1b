#include "host-sim/trace/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "hal/host/system_call.hpp"

namespace sim {
namespace {

/// An open input. A file is closed at the end of the scope; standard input stays open.
class OpenInput {
 public:
  explicit OpenInput(const std::string& file)
      : name_{name_of_input(file)},
        owned_{file != "-"},
        descriptor_{owned_ ? hal::host::open_file(file, O_RDONLY | O_CLOEXEC | O_NOCTTY)
                           : STDIN_FILENO} {
    if (descriptor_ < 0) fail();
  }
  ~OpenInput() {
    if (owned_ && descriptor_ >= 0) static_cast<void>(::close(descriptor_));
  }
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;

  [[nodiscard]] std::string read() const {
    std::string text;
    std::array<char, 1U << 16U> part{};
    for (;;) {
      const ::ssize_t count = ::read(descriptor_, part.data(), part.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      if (count == 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  [[noreturn]] void fail() const { throw std::system_error{errno, std::generic_category(), name_}; }

  std::string name_;
  bool owned_;
  int descriptor_;
};

/// Returns whether a text is binary data. A few control bytes are accepted, because the reader of
/// the text handles them. In a picture, an archive or UTF-16 text, many bytes are control bytes.
bool is_binary(std::string_view text) {
  constexpr std::size_t kLookedAt = 4096;
  constexpr std::ptrdiff_t kFewest = 8;
  constexpr std::ptrdiff_t kOneIn = 32;
  const std::string_view start = text.substr(0, kLookedAt);
  const auto strange = std::ranges::count_if(start, [](char letter) {
    constexpr std::string_view kBlanks = "\t\n\v\f\r\x1A\x1B";  // DOS ends text files with 0x1A.
    return static_cast<unsigned char>(letter) < ' ' &&
           kBlanks.find(letter) == std::string_view::npos;
  });
  return strange >= kFewest && strange * kOneIn >= std::ssize(start);
}

}  // namespace

std::string name_of_input(const std::string& file) { return file == "-" ? "standard input" : file; }

std::string read_bytes(const std::string& file) {
  std::string bytes = OpenInput{file}.read();
  if (bytes.empty() && file == "-") {
    throw std::invalid_argument("standard input: is empty; send the text to it, or name a file");
  }
  return bytes;
}

std::string read_text(const std::string& file, bool may_be_packed) {
  std::string text = read_bytes(file);
  // These formats are binary, but the importer of drawings reads them.
  constexpr std::string_view kGzip = "\x1F\x8B";
  const bool is_drawing = text.starts_with("AutoCAD Binary DXF") || text.starts_with("%PDF") ||
                          (may_be_packed && text.starts_with(kGzip));
  if (is_binary(text) && !is_drawing) {
    throw std::invalid_argument(fmt::format(
        "{}: is a binary file, not text; choose a file that is saved as plain text or UTF-8",
        name_of_input(file)));
  }
  return text;
}

}  // namespace sim

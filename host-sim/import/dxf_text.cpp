#include "host-sim/import/dxf_text.hpp"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

namespace sim::drawing {
namespace {

constexpr std::string_view kEscape = "\\U+";
constexpr std::size_t kEscapeDigits = 4;

/// Returns the number of bytes of the UTF-8 character at the front of a text; 0 if the text does
/// not begin with UTF-8.
std::size_t utf8_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || length > text.size()) return 0;
  for (const char byte : text.substr(1, length - 1)) {
    if ((static_cast<unsigned char>(byte) & 0xC0U) != 0x80U) return 0;
  }
  return length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// Returns the value of $DWGCODEPAGE in upper case; empty if the header has none.
std::string code_page_of(std::string_view text) {
  constexpr std::size_t kHeaderBytes = 200'000;
  const std::string_view head = text.substr(0, kHeaderBytes);
  std::size_t at = head.find("$DWGCODEPAGE");
  for (int line = 0; line < 2 && at != std::string_view::npos; ++line) {
    at = head.find('\n', at);
    if (at != std::string_view::npos) ++at;
  }
  if (at == std::string_view::npos) return {};
  std::string page{head.substr(at, head.find('\n', at) - at)};
  std::erase_if(page, [](char c) { return c == ' ' || c == '\r' || c == '\t'; });
  std::ranges::transform(page, page.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  });
  return page;
}

/// Converts text of a code page to UTF-8. The destructor closes the converter.
class CodePage {
 public:
  explicit CodePage(const std::string& name) : handle_{iconv_open("UTF-8", name.c_str())} {}
  CodePage(const CodePage&) = delete;
  CodePage& operator=(const CodePage&) = delete;
  CodePage(CodePage&&) = delete;
  CodePage& operator=(CodePage&&) = delete;
  ~CodePage() {
    if (is_known()) iconv_close(handle_);
  }

  [[nodiscard]] bool is_known() const {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): iconv_open() returns -1 if it fails.
    return handle_ != reinterpret_cast<iconv_t>(-1);
  }

  /// Returns a text converted to UTF-8. Adds to `replaced` the number of bytes that were replaced
  /// by `?`.
  std::string utf8_of(std::string text, std::size_t& replaced) {
    std::string out;
    std::array<char, 4096> buffer{};
    char* from = text.data();
    std::size_t left = text.size();
    while (left != 0) {
      char* to = buffer.data();
      std::size_t free = buffer.size();
      const std::size_t before = left;
      const std::size_t done = iconv(handle_, &from, &left, &to, &free);
      out.append(buffer.data(), buffer.size() - free);
      if (done != static_cast<std::size_t>(-1) || (left != before && free != buffer.size()))
        continue;
      if (free == buffer.size() && left != 0) {
        ++from;
        --left;
        ++replaced;
        out += '?';
      }
    }
    return out;
  }

 private:
  iconv_t handle_;
};

/// Returns the name under which iconv knows a code page of a drawing; empty if the code page has no
/// such name.
std::string library_name(const std::string& page) {
  const auto number_after = [&](std::string_view prefix) {
    return page.starts_with(prefix) ? page.substr(prefix.size()) : std::string{};
  };
  if (page.starts_with("ISO") || page == "ASCII") return page == "ASCII" ? "LATIN1" : page;
  if (page == "ANSI_1361") return "JOHAB";
  std::string number = number_after("ANSI_");
  if (number.empty()) number = number_after("DOS");
  return number.empty() ? std::string{} : "CP" + number;
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto rest = [&](unsigned shift) {
    out += static_cast<char>(0x80U | (code >> shift & 0x3FU));
  };
  if (code < 0x80U) {
    out += static_cast<char>(code);
  } else if (code < 0x800U) {
    out += static_cast<char>(0xC0U | code >> 6U);
    rest(0);
  } else if (code < 0x10000U) {
    out += static_cast<char>(0xE0U | code >> 12U);
    rest(6);
    rest(0);
  } else {
    out += static_cast<char>(0xF0U | code >> 18U);
    rest(12);
    rest(6);
    rest(0);
  }
}

/// Returns the UTF-16 code unit of a `\U+XXXX` at the front of the text; nothing if the text does
/// not begin with one.
std::optional<std::uint32_t> escaped_unit(std::string_view text) {
  if (!text.starts_with(kEscape) || text.size() < kEscape.size() + kEscapeDigits) return {};
  const std::string_view digits = text.substr(kEscape.size(), kEscapeDigits);
  std::uint32_t unit = 0;
  const auto [stop, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), unit, 16);
  if (error != std::errc{} || stop != digits.data() + digits.size()) return {};
  return unit;
}

/// Returns a text with each `\U+XXXX` replaced by its character. Escaped control characters stay as
/// they are, because a line end among them would change the lines of the file.
std::string without_escapes(const std::string& text) {
  constexpr std::size_t kLength = kEscape.size() + kEscapeDigits;
  std::string out;
  std::size_t at = 0;
  for (std::size_t next = text.find(kEscape); next != std::string::npos;
       next = text.find(kEscape, at)) {
    out.append(text, at, next - at);
    const std::string_view rest = std::string_view{text}.substr(next);
    const auto unit = escaped_unit(rest);
    at = next + (unit ? kLength : 1);
    if (!unit || *unit < 0x20U) {
      out.append(text, next, at - next);
      continue;
    }
    const auto low = escaped_unit(rest.substr(kLength));
    if (*unit >= 0xD800U && *unit < 0xDC00U && low && *low >= 0xDC00U && *low < 0xE000U) {
      append_utf8(out, 0x10000U + (*unit - 0xD800U) * 0x400U + (*low - 0xDC00U));
      at += kLength;
    } else if (*unit >= 0xD800U && *unit < 0xE000U) {
      out += '?';
    } else {
      append_utf8(out, *unit);
    }
  }
  out.append(text, at);
  return out;
}

}  // namespace

std::string utf8_of_dxf(std::string text, Sketch& sketch) {
  if (!is_utf8(text)) {
    constexpr const char* kUsual = "CP1252";
    const std::string page = code_page_of(text);
    const std::string name = library_name(page);
    std::size_t replaced = 0;
    if (CodePage stated{name}; !name.empty() && stated.is_known()) {
      text = stated.utf8_of(std::move(text), replaced);
    } else {
      text = CodePage{kUsual}.utf8_of(std::move(text), replaced);
      const std::string why =
          page.empty() ? "is missing" : fmt::format("{:.40} is no known code page", page);
      sketch.note(fmt::format("$DWGCODEPAGE {}: names are read as ANSI_1252", why), {});
    }
    if (replaced != 0) {
      sketch.note(
          fmt::format("{} bytes are no characters of the code page: each is read as `?`", replaced),
          {},
          "save the drawing again");
    }
  }
  return text.find(kEscape) == std::string::npos ? text : without_escapes(text);
}

}  // namespace sim::drawing

#include "host-sim/import/dxf_binary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>

namespace sim::drawing {
namespace {

constexpr std::string_view kSentinel = "AutoCAD Binary DXF";
// Size of the sentinel with the four bytes that follow it: carriage return, line feed, substitute
// and zero.
constexpr std::size_t kSentinelBytes = kSentinel.size() + 4;

enum class BinaryKind : std::uint8_t { kText, kReal, kShort, kLong, kHuge, kFlag, kChunk };

/// The last group code of a range of codes, and the format of their values. Values of codes above
/// all ranges are text.
struct BinaryRange {
  int last;
  BinaryKind kind;
};

BinaryKind binary_kind(int code) {
  using enum BinaryKind;
  static constexpr auto kRanges = std::to_array<BinaryRange>(
      {{9, kText},     {59, kReal},   {79, kShort},  {89, kText},    {99, kLong},   {109, kText},
       {149, kReal},   {159, kText},  {169, kHuge},  {179, kShort},  {209, kText},  {239, kReal},
       {269, kText},   {289, kShort}, {299, kFlag},  {309, kText},   {319, kChunk}, {369, kText},
       {389, kShort},  {399, kText},  {409, kShort}, {419, kText},   {429, kLong},  {439, kText},
       {459, kLong},   {469, kReal},  {1003, kText}, {1004, kChunk}, {1009, kText}, {1059, kReal},
       {1070, kShort}, {1071, kLong}});
  for (const BinaryRange& range : kRanges) {
    if (code <= range.last) return range.kind;
  }
  return kText;
}

/// Reads numbers and texts, with the least significant byte first. A read beyond the end returns
/// nothing, and so do all later reads.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_{bytes} {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  std::optional<std::uint64_t> whole(std::size_t bytes) {
    const auto taken = take(bytes);
    if (!taken) return {};
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) {
      value = value << 8U | static_cast<unsigned char>((*taken)[i]);
    }
    return value;
  }

  std::optional<std::string_view> take(std::size_t bytes) {
    if (bytes > rest_.size()) {
      rest_ = {};
      return {};
    }
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }

  std::optional<std::string_view> text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) return take(rest_.size() + 1);
    const auto taken = take(end);
    rest_.remove_prefix(1);
    return taken;
  }

 private:
  std::string_view rest_;
};

/// Reads the groups of a file one by one. Group codes have two bytes, or one byte in files of
/// Release 12.
class BinaryGroups {
 public:
  explicit BinaryGroups(std::string_view bytes)
      // The first group code is 0. If the second byte is zero, too, it belongs to a code of two
      // bytes. Otherwise it begins the name of a section.
      : reader_{bytes}, has_short_codes_{bytes.size() > 1 && bytes[1] != '\0'} {}

  std::string as_lines() {
    std::string lines;
    while (!reader_.at_end()) {
      const auto code = next_code();
      const auto value = code ? value_of(*code) : std::nullopt;
      if (!value) break;
      lines += fmt::format("{}\n{}\n", *code, *value);
    }
    return lines;
  }

 private:
  std::optional<int> next_code() {
    constexpr std::uint64_t kLongCodeFollows = 255;
    auto code = reader_.whole(has_short_codes_ ? 1 : 2);
    if (has_short_codes_ && code == kLongCodeFollows) code = reader_.whole(2);
    if (!code) return {};
    return static_cast<int>(static_cast<std::int16_t>(*code));
  }

  template <typename Signed>
  std::optional<std::string> signed_text() {
    const auto value = reader_.whole(sizeof(Signed));
    if (!value) return {};
    return std::to_string(static_cast<Signed>(*value));
  }

  std::optional<std::string> line_text() {
    const auto value = reader_.text();
    if (!value) return {};
    std::string line{*value};
    std::ranges::replace(line, '\n', ' ');
    return line;
  }

  std::optional<std::string> value_of(int code) {
    switch (binary_kind(code)) {
      case BinaryKind::kShort:
        return signed_text<std::int16_t>();
      case BinaryKind::kLong:
        return signed_text<std::int32_t>();
      case BinaryKind::kHuge:
        return signed_text<std::int64_t>();
      case BinaryKind::kFlag:
        return signed_text<std::int8_t>();
      case BinaryKind::kReal: {
        const auto bits = reader_.whole(sizeof(double));
        if (!bits) return {};
        return fmt::format("{}", std::bit_cast<double>(*bits));
      }
      case BinaryKind::kChunk: {
        const auto length = reader_.whole(1);
        if (!length || !reader_.take(static_cast<std::size_t>(*length))) return {};
        return std::string{};
      }
      case BinaryKind::kText:
        break;
    }
    return line_text();
  }

  ByteReader reader_;
  bool has_short_codes_;
};

}  // namespace

bool is_binary_dxf(std::string_view text) { return text.starts_with(kSentinel); }

std::string ascii_of_binary_dxf(std::string_view text) {
  text.remove_prefix(std::min(kSentinelBytes, text.size()));
  return BinaryGroups{text}.as_lines();
}

}  // namespace sim::drawing

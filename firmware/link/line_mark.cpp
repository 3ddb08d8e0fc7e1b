#include "firmware/link/line_mark.hpp"

#include <algorithm>
#include <span>

#include "planner/gcode/line_reader.hpp"

namespace cnc {
namespace {

constexpr std::size_t kCrcDigits = 8;
constexpr std::size_t kMaxSumDigits = 3;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

// Two functions are used instead of string_view::substr, which may throw, because exceptions are
// disabled.
std::string_view head_of(std::size_t place, std::string_view text) {
  text.remove_suffix(text.size() - place);
  return text;
}

std::string_view tail_of(std::size_t place, std::string_view text) {
  text.remove_prefix(place);
  return text;
}

/// Returns whether `digits` can be a check: one to three decimal digits of a sum, or the eight
/// digits of a CRC.
bool looks_like_check(std::string_view digits) {
  if (digits.size() == kCrcDigits) return true;
  return !digits.empty() && digits.size() <= kMaxSumDigits && std::ranges::all_of(digits, is_digit);
}

void put_digits(std::uint32_t crc, char* digits) {
  constexpr std::string_view kHexadecimal = "0123456789ABCDEF";
  for (std::size_t i = kCrcDigits; i > 0; --i, crc >>= 4U) digits[i - 1] = kHexadecimal[crc & 15U];
}

LineMark::Form form_of(std::uint32_t crc, std::uint8_t sum, std::string_view digits) {
  if (digits.size() == kCrcDigits) {
    std::array<char, kCrcDigits> expected{};
    put_digits(crc, expected.data());
    const bool fits = digits == std::string_view{expected.data(), expected.size()};
    return fits ? LineMark::Form::kCrc : LineMark::Form::kNone;
  }
  std::uint32_t written = 0;
  for (const char c : digits) written = 10 * written + static_cast<std::uint32_t>(c - '0');
  return written == sum ? LineMark::Form::kSum : LineMark::Form::kNone;
}

std::uint32_t crc_of(std::string_view text) {
  Crc32 crc;
  crc.add(std::as_bytes(std::span{text}));
  return crc.value();
}

}  // namespace

void put_line_crc(std::string_view covered, char* digits) { put_digits(crc_of(covered), digits); }

LineMark::Form LineMark::form() const {
  std::uint8_t sum = 0;
  for (const char c : covered) sum ^= static_cast<std::uint8_t>(c);
  const bool is_crc = digits.size() == kCrcDigits;
  return form_of(is_crc ? crc_of(covered) : 0, sum, digits);
}

MarkFinder::Part MarkFinder::add(char byte) {
  const std::size_t place = place_++;
  if (closing_ != ' ') {
    if (byte == closing_ && closing_ != ';') closing_ = ' ';
    return Part::kOther;
  }
  if (byte == '*') {
    star_ = place;
    end_ = place_;
    return Part::kStar;
  }
  if (end_ == place && is_hex_digit(byte)) {
    end_ = place_;
    return Part::kDigit;
  }
  if (byte == ';') {
    closing_ = ';';
  } else if (byte == '(') {
    closing_ = ')';
  } else if (!gcode::is_blank(byte)) {
    if (byte == '[') closing_ = ']';
    star_ = kNowhere;
  }
  return Part::kOther;
}

std::optional<LineMark> find_mark(std::string_view line) {
  if (line.find('*') == std::string_view::npos) return std::nullopt;
  MarkFinder finder;
  for (const char c : line) finder.add(c);
  if (!finder.found()) return std::nullopt;
  const LineMark mark{head_of(finder.star(), line),
                      tail_of(finder.star() + 1, head_of(finder.end(), line))};
  return looks_like_check(mark.digits) ? std::optional{mark} : std::nullopt;
}

std::optional<LineMark> mark_at_end(std::string_view line) {
  if (line.size() <= kCrcDigits) return std::nullopt;
  const std::size_t star = line.size() - kCrcDigits - 1;
  if (line[star] != '*') return std::nullopt;
  return LineMark{head_of(star, line), tail_of(star + 1, line)};
}

void LongLineCheck::Star::put(char digit) {
  if (count < digits.size()) digits[count] = digit;
  if (count <= digits.size()) ++count;
}

std::string_view LongLineCheck::Star::text() const {
  return count <= digits.size() ? std::string_view{digits.data(), count} : std::string_view{};
}

void LongLineCheck::add(char byte) {
  const MarkFinder::Part part = finder_.add(byte);
  last_.put(byte);
  if (byte == '*') {
    last_ = {.crc = crc_.value(), .sum = sum_};
    if (part == MarkFinder::Part::kStar) mark_ = last_;
  } else if (part == MarkFinder::Part::kDigit) {
    mark_.put(byte);
  }
  crc_.add(static_cast<std::byte>(byte));
  sum_ ^= static_cast<std::uint8_t>(byte);
}

bool LongLineCheck::found(bool at_end) const {
  const std::string_view digits = (at_end ? last_ : mark_).text();
  return at_end ? digits.size() == kCrcDigits : finder_.found() && looks_like_check(digits);
}

LineMark::Form LongLineCheck::form(bool at_end) const {
  const Star& star = at_end ? last_ : mark_;
  return form_of(star.crc, star.sum, star.text());
}

}  // namespace cnc

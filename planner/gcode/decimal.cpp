#include "planner/gcode/decimal.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace cnc::gcode {

namespace {

constexpr std::uint32_t kBillion = 1'000'000'000;
constexpr std::uint32_t kLargestWhole = kBillion - 1;
constexpr std::size_t kDecimals = 9;
constexpr std::array<std::uint32_t, kDecimals + 1> kPowersOfTen{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, kBillion};

/// Reads the characters of a text and skips blanks. For speed, it checks for blanks only if the
/// next character is not a digit.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_{text} {}

  /// Skips blanks and returns the index of the next character.
  [[nodiscard]] std::size_t position() {
    skip_blanks();
    return at_;
  }
  [[nodiscard]] std::size_t digits_taken() const { return digits_taken_; }

  [[nodiscard]] bool at_digit() {
    if (stands_on_digit()) return true;
    skip_blanks();
    return stands_on_digit();
  }
  /// Returns the value of the digit at the present index. @pre at_digit()
  [[nodiscard]] std::uint32_t digit() const { return static_cast<std::uint32_t>(text_[at_] - '0'); }

  void leave_digit() {
    ++digits_taken_;
    ++at_;
  }

  /// Skips the next character after blanks if it is `wanted`. Returns whether it was `wanted`.
  bool take(char wanted) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

 private:
  [[nodiscard]] bool stands_on_digit() const {
    return at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9';
  }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t digits_taken_ = 0;
};

/// Reads the digits before the point. Returns false if there are too many.
bool read_whole(Cursor& cursor, Decimal& number) {
  for (; cursor.at_digit(); cursor.leave_digit()) {
    if (number.whole > kLargestWhole / 10) return false;
    number.whole = number.whole * 10 + cursor.digit();
  }
  return true;
}

void round_up(Decimal& number) {
  if (++number.billionths < kBillion) return;
  number.billionths = 0;
  ++number.whole;
}

void read_fraction(Cursor& cursor, Decimal& number) {
  std::size_t decimals = 0;
  for (; cursor.at_digit() && decimals < kDecimals; cursor.leave_digit(), ++decimals) {
    number.billionths = number.billionths * 10 + cursor.digit();
  }
  number.billionths *= kPowersOfTen[kDecimals - decimals];
  if (cursor.at_digit() && cursor.digit() >= 5) round_up(number);
  while (cursor.at_digit()) cursor.leave_digit();
}

/// Reads a number of at most nine digits without any blanks, as a single integer. Nearly all
/// numbers are of this kind. Returns nothing for any other text.
std::optional<DecimalReading> read_plain(std::string_view text) {
  DecimalReading reading{};
  std::size_t at = 0;
  if (!text.empty() && text.front() == '-') {
    reading.value.minus = true;
    ++at;
  }
  std::uint32_t all = 0;
  std::size_t digits = 0;
  std::size_t whole_digits = kDecimals + 1;  // This value means that no point has been read yet.
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c >= '0' && c <= '9') {
      if (++digits > kDecimals) return std::nullopt;
      all = all * 10 + static_cast<std::uint32_t>(c - '0');
    } else if (c == '.' && whole_digits > kDecimals) {
      whole_digits = digits;
    } else if (is_blank(c)) {
      return std::nullopt;
    } else {
      break;
    }
  }
  if (digits == 0) return std::nullopt;
  const std::size_t decimals = digits - std::min(digits, whole_digits);
  const std::uint32_t unit = kPowersOfTen[decimals];
  reading.value.whole = all / unit;
  reading.value.billionths =
      (all - reading.value.whole * unit) * kPowersOfTen[kDecimals - decimals];
  reading.length = at;
  return reading;
}

Coordinate signed_place(std::uint64_t nanometres, bool minus) {
  const auto magnitude = static_cast<std::int64_t>(nanometres);
  return Coordinate{minus ? -magnitude : magnitude};
}

}  // namespace

Result<DecimalReading, DecimalError> read_decimal(std::string_view text) {
  if (const auto plain = read_plain(text)) return *plain;
  Cursor cursor{text};
  Decimal number{};
  number.minus = cursor.take('-');
  if (!number.minus) static_cast<void>(cursor.take('+'));
  if (!read_whole(cursor, number)) return DecimalError::kTooLong;
  if (cursor.take('.')) read_fraction(cursor, number);
  if (cursor.digits_taken() == 0) return DecimalError::kNoDigits;
  return DecimalReading{number, cursor.position()};
}

float Decimal::to_float() const {
  const float magnitude = static_cast<float>(whole) + static_cast<float>(billionths) * 1.0e-9F;
  return minus ? -magnitude : magnitude;
}

std::int64_t Decimal::in_billionths() const {
  const auto magnitude = static_cast<std::int64_t>(whole) * kBillion + billionths;
  return minus ? -magnitude : magnitude;
}

Coordinate from_millimetres(const Decimal& number) {
  constexpr std::uint64_t kNanometres = 1'000'000;
  const std::uint32_t fraction = (number.billionths + 500) / 1000;
  return signed_place(number.whole * kNanometres + fraction, number.minus);
}

Coordinate from_inches(const Decimal& number) {
  constexpr std::uint64_t kNanometres = 25'400'000;
  // A billionth of an inch is 0.0254 nm = 127 / 5000 nm. The multiplication is done in two parts,
  // so that the products stay within 32 bits.
  const std::uint32_t quotient = number.billionths / 5000;
  const std::uint32_t rest = number.billionths % 5000;
  const std::uint32_t fraction = quotient * 127 + (rest * 127 + 2500) / 5000;
  return signed_place(number.whole * kNanometres + fraction, number.minus);
}

}  // namespace cnc::gcode

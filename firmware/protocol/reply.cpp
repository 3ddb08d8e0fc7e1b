#include "firmware/protocol/reply.hpp"

#include <algorithm>
#include <array>

namespace cnc {
namespace {

constexpr std::array<std::uint32_t, 7> kPowers{1, 10, 100, 1000, 10'000, 100'000, 1'000'000};

std::uint32_t digits_of(std::uint32_t whole) {
  std::uint32_t count = 0;
  for (; whole != 0; whole /= 10U) ++count;
  return count;
}

}  // namespace

Reply& Reply::text(std::string_view words) {
  const std::size_t count = std::min(words.size(), room().size());
  std::copy_n(words.begin(), count, bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += count;
  return *this;
}

Reply& Reply::end() {
  std::copy(kEnd.begin(), kEnd.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += kEnd.size();
  return *this;
}

Reply& Reply::number(std::uint32_t value) {
  std::array<char, 10> digits{};
  std::size_t first = digits.size();
  do {
    digits[--first] = static_cast<char>('0' + value % 10U);
    value /= 10U;
  } while (value != 0);
  return text({digits.data() + first, digits.size() - first});
}

/// Appends a decimal point and exactly `count` digits; appends nothing if `count` is 0.
Reply& Reply::fraction(std::uint32_t digits, std::uint32_t count) {
  if (count == 0) return *this;
  letter('.');
  while (count > 0) letter(static_cast<char>('0' + digits / kPowers[--count] % 10U));
  return *this;
}

Reply& Reply::value(float value, std::uint32_t least) {
  if (value < 0.0F) letter('-');
  const float magnitude = value < 0.0F ? -value : value;
  auto units = static_cast<std::uint32_t>(magnitude);
  // Significant digits of a float; more digits would show its rounding.
  constexpr std::uint32_t kDigits = 7;
  const std::uint32_t before = digits_of(units);
  std::uint32_t count = std::min<std::uint32_t>(
      kPowers.size() - 1, std::max<std::uint32_t>(least, kDigits - std::min(kDigits, before)));
  const float rest = magnitude - static_cast<float>(units);
  auto digits = static_cast<std::uint32_t>(rest * static_cast<float>(kPowers[count]) + 0.5F);
  if (digits >= kPowers[count]) {
    digits -= kPowers[count];
    ++units;
  }
  for (; count > least && digits % 10U == 0; --count) digits /= 10U;
  return number(units).fraction(digits, count);
}

Reply& Reply::whole(float value) {
  if (value < 0.0F) letter('-');
  return number(static_cast<std::uint32_t>((value < 0.0F ? -value : value) + 0.5F));
}

Reply& Reply::place(Coordinate place, bool inches) {
  constexpr std::uint64_t kPerThousandth = 1000;     // Nanometres in a thousandth of a millimetre.
  constexpr std::uint64_t kPerTenThousandth = 2540;  // Nanometres in a ten-thousandth of an inch.
  const std::int64_t nanometres = place.nanometres();
  const auto magnitude = static_cast<std::uint64_t>(nanometres < 0 ? -nanometres : nanometres);
  const std::uint64_t step = inches ? kPerTenThousandth : kPerThousandth;
  // No coordinate exceeds a kilometre, which is 10^9 thousandths of a millimetre. So `steps` fits
  // into 32 bits.
  const auto steps = static_cast<std::uint32_t>((magnitude + step / 2) / step);
  const std::uint32_t decimals = inches ? 4 : 3;
  if (nanometres < 0 && steps != 0) letter('-');
  return number(steps / kPowers[decimals]).fraction(steps % kPowers[decimals], decimals);
}

}  // namespace cnc

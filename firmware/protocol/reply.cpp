#include "firmware/protocol/reply.hpp"

#include <algorithm>

namespace cnc {

Reply& Reply::text(std::string_view words) {
  const std::size_t count = std::min(words.size(), bytes_.size() - size_);
  std::copy_n(words.begin(), count, bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += count;
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

}  // namespace cnc

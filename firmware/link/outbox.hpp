#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "hal/interface/byte_stream.hpp"
#include "planner/base/contract.hpp"

namespace cnc {

/// Answers on their way to a link that may take only part of them at a time.
template <std::size_t Capacity>
class Outbox {
 public:
  [[nodiscard]] bool empty() const { return sent_ == size_; }

  /// @pre it fits with what is still unsent
  void add(std::string_view words) {
    if (empty()) sent_ = size_ = 0;
    CNC_ASSERT(words.size() <= Capacity - size_);
    std::copy(words.begin(), words.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += words.size();
  }

  /// Sends what the link takes now.
  void send(hal::ByteStream& link) {
    if (empty()) return;
    const std::span<const char> unsent{bytes_.data() + sent_, size_ - sent_};
    sent_ += link.write(std::as_bytes(unsent));
  }

 private:
  std::array<char, Capacity> bytes_{};
  std::size_t size_ = 0;
  std::size_t sent_ = 0;
};

}  // namespace cnc

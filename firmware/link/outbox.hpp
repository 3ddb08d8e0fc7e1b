#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "planner/base/contract.hpp"

namespace cnc {

/// Answers that wait until a link accepts them. A link may accept only a part of the bytes in one
/// call.
template <std::size_t Capacity>
class Outbox {
 public:
  [[nodiscard]] bool empty() const { return sent_ == size_; }

  /// Returns space for the next answer, after the unsent bytes. The caller then reports the number
  /// of filled bytes with `wrote`.
  /// @pre Count bytes are free
  template <std::size_t Count>
  [[nodiscard]] std::span<char, Count> room() {
    if (empty()) sent_ = size_ = 0;
    CNC_ASSERT(Count <= Capacity - size_);
    return std::span<char, Count>{bytes_.data() + size_, Count};
  }
  void wrote(std::size_t count) { size_ += count; }

  /// Sends as many bytes as the link accepts now.
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

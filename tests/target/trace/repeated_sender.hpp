#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hal/interface/byte_stream.hpp"
#include "tests/target/trace/timed_sender.hpp"

namespace trace {

/// Sends recorded bytes again in the same cycles, and ignores the answers.
class RepeatedSender final : public hal::ByteStream {
 public:
  /// @param bursts numbers of bytes in order of cycles
  RepeatedSender(std::string sent, std::vector<Burst> bursts)
      : sent_{std::move(sent)}, bursts_{std::move(bursts)} {}

  /// Begins a cycle: the bytes that had arrived by its due time can be read, however late it runs.
  void begin_turn(std::uint32_t turn) {
    for (; next_ < bursts_.size() && bursts_[next_].turn <= turn; ++next_) {
      arrived_ += bursts_[next_].bytes;
    }
  }

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), arrived_ - read_);
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(sent_[read_ + i]);
    read_ += count;
    return count;
  }
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override { return from.size(); }

 private:
  std::string sent_;
  std::vector<Burst> bursts_;
  std::size_t next_ = 0;  ///< Index of the next burst.
  std::size_t arrived_ = 0;
  std::size_t read_ = 0;
};

}  // namespace trace

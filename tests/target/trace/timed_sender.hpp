#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/interface/byte_stream.hpp"

namespace trace {

/// A realtime byte that arrives in a given cycle.
struct Injection {
  std::uint32_t turn = 0;
  char byte = 0;
};

/// Number of bytes that arrive between the boundary before this cycle and the cycle's own boundary.
struct Burst {
  std::uint32_t turn = 0;
  std::size_t bytes = 0;
};

/// A sender that counts characters. Its bytes in each cycle follow from the answers before, and are
/// recorded, so that the same bytes can arrive at the same ticks elsewhere.
class TimedSender final : public hal::ByteStream {
 public:
  /// Greatest number of bytes in a cycle: 0.8 ms at 1 Mbaud.
  static constexpr std::size_t kBurst = 80;
  /// Greatest number of bytes in lines without an answer.
  static constexpr std::size_t kWindow = 512;

  /// @param program lines, each with its line end @param injections in order of cycles
  TimedSender(std::string program, std::vector<Injection> injections)
      : program_{std::move(program)}, injections_{std::move(injections)} {}

  /// Delivers the bytes that arrive before this cycle's boundary.
  void arrive_before(std::uint32_t turn);

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;

  [[nodiscard]] bool finished() const { return next_ == program_.size() && lines_.empty(); }
  [[nodiscard]] const std::string& sent() const { return sent_; }
  [[nodiscard]] const std::vector<Burst>& bursts() const { return bursts_; }
  [[nodiscard]] std::size_t refused() const { return refused_; }

 private:
  [[nodiscard]] bool line_fits();
  void take_answer(std::string_view answer);

  std::string program_;
  std::vector<Injection> injections_;
  std::size_t next_ = 0;      ///< Index of the next byte of the program.
  std::size_t injected_ = 0;  ///< Number of injections that have arrived.
  bool in_line_ = false;
  std::deque<std::size_t> lines_;  ///< Lengths of the lines without an answer.
  std::size_t unanswered_ = 0;
  std::string sent_;
  std::size_t read_ = 0;
  std::vector<Burst> bursts_;
  std::string heard_;
  std::size_t refused_ = 0;
};

}  // namespace trace

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "hal/interface/session_stream.hpp"

namespace cnc {

/// Two links, of which one at a time has the word: the first while somebody has it
/// open, else the second, which is always there. Main loop.
///
/// Answers go to whoever has the word. What comes over the second meanwhile is dropped,
/// and so is the rest of a line of which a part was: no line is put together from what
/// two senders sent, or from the end of one.
class LinkChoice final : public hal::ByteStream {
 public:
  enum class Change : std::uint8_t {
    kNone,
    kCame,  ///< A sender opened the first link.
    kWent,  ///< It is gone, and no other came.
  };

  /// Both outlive this.
  LinkChoice(hal::SessionStream& first, hal::ByteStream& second) : first_{first}, second_{second} {}

  /// Looks who is there; until the next look nothing changes hands. Before each turn.
  [[nodiscard]] Change attend();

  [[nodiscard]] bool first_has_word() const { return session_ != 0; }

  /// Nothing from and to a sender who came after the last look.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] bool may_wait() const override {
    return session_ != 0 ? first_.may_wait() : second_.may_wait();
  }

 private:
  void drop_second();
  [[nodiscard]] bool belongs_to_whole_line(std::byte byte);

  hal::SessionStream& first_;
  hal::ByteStream& second_;
  std::uint32_t session_ = 0;  ///< 0: the second has the word.
  bool within_line_ = false;   ///< The second is in the middle of a line,
  bool skipping_ = false;      ///< of which the beginning was dropped.
};

}  // namespace cnc

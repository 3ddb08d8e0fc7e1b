#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firmware/link/receiver.hpp"
#include "host-sim/serve/byte_blocks.hpp"
#include "host-sim/serve/session.hpp"

namespace sim {

/// Reads a sender's stream ahead of the controller, so that realtime bytes act and a closed
/// connection is noticed however many lines wait.
///
/// A second `cnc::Receiver` sorts the bytes by the controller's own rules: realtime bytes go
/// ahead of the lines at once, bytes of lines wait here until the controller has capacity for
/// them. A reset forgets the lines before it, as it does in the controller. In a tool change 0xA3
/// and `~` stay where they are among the lines, because they say which lines belong to it.
class LookAhead {
 public:
  /// Bytes of lines that wait at most. A sender that is further ahead is to be hung up on:
  /// its realtime bytes could not be read any more.
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  LookAhead();

  /// Sorts what a sender has sent, in order.
  void hear(std::span<const std::byte> bytes, Session& session);
  /// Hands lines to the controller as far as its link has capacity.
  void hand_over(Session& session);

  /// Takes all lines, and the beginning of one, instead; realtime bytes among them act.
  [[nodiscard]] std::string take_lines(Session& session);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool overrun() const { return size() > kMost; }
  /// Forgets everything: the sender is gone, or another one begins.
  void forget();

 private:
  void act_on_realtime(Session& session);
  [[nodiscard]] bool keep_in_order(cnc::RealtimeByte command, Session& session);
  void keep_lines();

  std::unique_ptr<cnc::Receiver> receiver_;  ///< Always there.
  ByteBlocks lines_;
  /// Realtime bytes that were kept among the lines, since the controller had heard all of them.
  std::vector<cnc::RealtimeByte> marks_;
};

}  // namespace sim

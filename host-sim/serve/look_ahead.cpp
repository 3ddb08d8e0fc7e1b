#include "host-sim/serve/look_ahead.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace sim {
namespace {

// The receiver has capacity for a chunk, whatever it is in the middle of.
constexpr std::size_t kChunk = 64;
static_assert(kChunk < cnc::Receiver::kRealBytes);

std::span<const char> as_chars(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

LookAhead::LookAhead() : receiver_{std::make_unique<cnc::Receiver>()} {}

void LookAhead::hear(std::span<const std::byte> bytes, Session& session) {
  const bool strict = session.controller().firmware().checks_lines();
  receiver_->be_strict(strict);
  std::span<const char> rest = as_chars(bytes);
  while (!rest.empty()) {
    // Most bytes need no sorting; the last of them tells the receiver where it is.
    const std::size_t run = strict ? 0 : receiver_->plain_run(rest);
    if (run > kChunk) {
      lines_.append(rest.data(), run - 1);
      rest = rest.subspan(run - 1);
    }
    const std::span<const char> chunk = rest.first(std::min(rest.size(), kChunk));
    const std::size_t count = receiver_->receive(chunk);
    CNC_ASSERT(count == chunk.size());
    rest = rest.subspan(count);
    act_on_realtime(session);
    keep_lines();
  }
}

/// In the order of the receiver: a reset first, because it has forgotten what came before it.
void LookAhead::act_on_realtime(Session& session) {
  if (receiver_->take_reset()) {
    lines_.clear();
    taken_ = 0;
    session.link().drop_incoming();
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kReset));
  }
  if (receiver_->take_status_request()) {
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kStatus));
  }
  if (receiver_->take_full_status_request()) {
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kFullStatus));
  }
  for (cnc::RealtimeByte command{}; receiver_->take_command(command);) {
    session.act_at_once(static_cast<std::byte>(command));
  }
}

void LookAhead::keep_lines() {
  static_cast<void>(receiver_->take_until([this](char byte) {
    lines_ += byte;
    return false;
  }));
}

void LookAhead::hand_over(Session& session) {
  const std::size_t count = std::min(session.link().room(), size());
  if (count == 0) return;
  session.link().receive(std::as_bytes(std::span{lines_}).subspan(taken_, count));
  taken_ += count;
  // Half of it at least is gone whenever the rest is moved.
  if (2 * taken_ < lines_.size()) return;
  lines_.erase(0, taken_);
  taken_ = 0;
}

std::string LookAhead::take_lines() {
  std::string lines = lines_.substr(taken_);
  lines_.clear();
  taken_ = 0;
  return lines;
}

void LookAhead::forget() {
  if (lines_.empty()) return receiver_->begin_anew();
  receiver_->begin_anew();
  static_cast<void>(receiver_->take_reset());
  lines_ = {};
  taken_ = 0;
}

}  // namespace sim

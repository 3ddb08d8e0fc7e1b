#include "firmware/link/can/iso_tp_receiver.hpp"

#include <algorithm>

namespace cnc {

using iso_tp::FlowControl;
using iso_tp::FlowStatus;
using iso_tp::FrameKind;

void IsoTpReceiver::take(std::span<const std::byte> payload, hal::TickCount now) {
  switch (iso_tp::kind_of(payload)) {
    case FrameKind::kSingle:
      take_single(payload);
      break;
    case FrameKind::kFirst:
      take_first(payload);
      break;
    case FrameKind::kConsecutive:
      take_consecutive(payload);
      break;
    default:
      return;
  }
  last_ = now;
}

void IsoTpReceiver::take_single(std::span<const std::byte> payload) {
  const std::size_t length = iso_tp::low_half(payload);
  if (length == 0 || length >= payload.size()) return;
  abandon();
  if (text_.room() < length) {
    ++counts_.lost;
    return;
  }
  text_.add(payload.subspan(1, length));
  text_.settle();
}

void IsoTpReceiver::take_first(std::span<const std::byte> payload) {
  if (payload.size() < 8) return;
  const std::uint32_t length = static_cast<std::uint32_t>(iso_tp::low_half(payload)) << 8 |
                               std::to_integer<std::uint32_t>(payload[1]);
  // A length of 0 means that four more bytes hold the length, because it exceeds 4095.
  if (length != 0 && length <= iso_tp::kInSingle) return;
  abandon();
  if (length == 0 || length > kLongest) {
    flow_ = Flow::kOverflow;
    return;
  }
  if (text_.room() < iso_tp::kInFirst) {
    ++counts_.lost;
    return;
  }
  text_.add(payload.subspan(2, iso_tp::kInFirst));
  left_ = length - static_cast<std::uint32_t>(iso_tp::kInFirst);
  number_ = 1;
  block_ = 0;
  flow_ = Flow::kAsked;
}

void IsoTpReceiver::take_consecutive(std::span<const std::byte> payload) {
  if (left_ == 0) return;
  const std::size_t bytes = std::min<std::size_t>(left_, iso_tp::kInConsecutive);
  const std::uint8_t number = iso_tp::low_half(payload);
  // A repetition of the previous frame is ignored.
  if (payload.size() <= bytes || number == ((number_ - 1) & 0xFU)) return;
  if (number != number_ || text_.room() < bytes) return abandon();
  text_.add(payload.subspan(1, bytes));
  number_ = (number_ + 1) & 0xFU;
  left_ -= static_cast<std::uint32_t>(bytes);
  if (left_ == 0) {
    text_.settle();
    flow_ = Flow::kNone;
  } else if (block_ > 0 && --block_ == 0) {
    flow_ = Flow::kAsked;
  }
}

void IsoTpReceiver::abandon() {
  if (left_ != 0) ++counts_.broken;
  left_ = block_ = 0;
  flow_ = Flow::kNone;
  text_.take_back();
}

std::uint32_t IsoTpReceiver::frames_left() const {
  return (left_ + static_cast<std::uint32_t>(iso_tp::kInConsecutive) - 1) /
         static_cast<std::uint32_t>(iso_tp::kInConsecutive);
}

/// Returns the number of the message's remaining frames that fit. The last frame may be short.
std::uint32_t IsoTpReceiver::frames_that_fit() const {
  const std::uint32_t room = text_.room();
  if (room < kReserve) return 0;
  if (room - kReserve >= left_) return frames_left();
  return (room - kReserve) / static_cast<std::uint32_t>(iso_tp::kInConsecutive);
}

std::optional<FlowControl> IsoTpReceiver::flow_due(hal::TickCount now) {
  if (flow_ == Flow::kOverflow) {
    flow_ = Flow::kNone;
    return FlowControl{.status = FlowStatus::kOverflow};
  }
  if (flow_ == Flow::kNone) {
    if (left_ != 0 && now.reached(last_.plus(iso_tp::kFrameTimeoutUs))) abandon();
    return std::nullopt;
  }
  const std::uint32_t fit = frames_that_fit();
  if (fit >= std::min(frames_left(), kMinBlock)) {
    flow_ = Flow::kNone;
    last_ = now;
    constexpr std::uint32_t kMax = 0xFF;
    block_ = std::min(fit, kMax);
    return FlowControl{.block_size = static_cast<std::uint8_t>(block_)};
  }
  if (flow_ == Flow::kWaiting && !now.reached(last_.plus(kWaitUs))) return std::nullopt;
  flow_ = Flow::kWaiting;
  last_ = now;
  return FlowControl{.status = FlowStatus::kWait};
}

std::size_t IsoTpReceiver::read(std::span<std::byte> into) {
  const auto count =
      static_cast<std::uint32_t>(std::min<std::size_t>(into.size(), text_.settled()));
  for (std::uint32_t at = 0; at < count; ++at) into[at] = text_.at(at);
  text_.drop(count);
  return count;
}

void IsoTpReceiver::clear() {
  left_ = block_ = 0;
  flow_ = Flow::kNone;
  text_.clear();
}

}  // namespace cnc

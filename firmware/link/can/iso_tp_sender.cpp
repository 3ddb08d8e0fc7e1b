#include "firmware/link/can/iso_tp_sender.hpp"

#include <algorithm>

namespace cnc {

using iso_tp::FlowStatus;
using iso_tp::FrameKind;
using iso_tp::Payload;

std::size_t IsoTpSender::write(std::span<const std::byte> from) {
  const auto some = from.first(std::min<std::size_t>(from.size(), text_.room()));
  text_.add(some);
  text_.settle();
  return some.size();
}

void IsoTpSender::take(std::span<const std::byte> payload, hal::TickCount now) {
  if (iso_tp::kind_of(payload) != FrameKind::kFlowControl || payload.size() < 3) return;
  if (step_ != Step::kAwaitsFlow) return;
  since_ = now;
  switch (static_cast<FlowStatus>(iso_tp::low_half(payload))) {
    case FlowStatus::kContinue:
      block_ = std::to_integer<std::uint32_t>(payload[1]);
      endless_ = block_ == 0;
      separation_us_ = iso_tp::separation_us(std::to_integer<std::uint8_t>(payload[2]));
      waits_ = 0;
      step_ = Step::kSends;
      return;
    case FlowStatus::kWait:
      if (++waits_ > kMaxWaits) give_up();
      return;
    case FlowStatus::kOverflow:
      longest_ = std::max<std::uint32_t>(length_ / 2, iso_tp::kInSingle);
      step_ = Step::kIdle;  // next() then sends the bytes again in a shorter message.
      return;
  }
}

std::optional<Payload> IsoTpSender::next(hal::TickCount now) {
  if (step_ == Step::kAwaitsFlow && now.reached(since_.plus(iso_tp::kFlowTimeoutUs))) {
    if (++tries_ == kTries) {
      give_up();
    } else {
      ++counts_.again;
      step_ = Step::kIdle;
    }
  }
  if (step_ == Step::kIdle && !empty()) return begin(now);
  if (step_ == Step::kSends && (sent_ <= iso_tp::kInFirst || separation_us_ == 0 ||
                                now.reached(since_.plus(separation_us_)))) {
    return consecutive(now);
  }
  return std::nullopt;
}

Payload IsoTpSender::begin(hal::TickCount now) {
  since_ = now;
  sent_ = 0;
  length_ = std::min(text_.settled(), longest_);
  Payload payload;
  if (length_ <= iso_tp::kInSingle) {
    payload.bytes[0] = iso_tp::first_byte(FrameKind::kSingle, length_);
    payload.length = 1;
    append(payload, length_);
    end_message();
    return payload;
  }
  payload.bytes[0] = iso_tp::first_byte(FrameKind::kFirst, length_ >> 8);
  payload.bytes[1] = static_cast<std::byte>(length_ & 0xFFU);
  payload.length = 2;
  append(payload, iso_tp::kInFirst);
  number_ = 1;
  waits_ = 0;
  step_ = Step::kAwaitsFlow;
  return payload;
}

Payload IsoTpSender::consecutive(hal::TickCount now) {
  since_ = now;
  Payload payload;
  payload.bytes[0] = iso_tp::first_byte(FrameKind::kConsecutive, number_);
  payload.length = 1;
  append(payload, std::min<std::uint32_t>(length_ - sent_, iso_tp::kInConsecutive));
  number_ = (number_ + 1) & 0xFU;
  if (sent_ == length_) {
    end_message();
  } else if (!endless_ && --block_ == 0) {
    step_ = Step::kAwaitsFlow;
  }
  return payload;
}

void IsoTpSender::append(Payload& payload, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) payload.bytes[payload.length++] = text_.at(sent_++);
}

void IsoTpSender::end_message() {
  text_.drop(length_);
  tries_ = 0;
  step_ = Step::kIdle;
}

void IsoTpSender::give_up() {
  ++counts_.given_up;
  clear();
}

void IsoTpSender::clear() {
  text_.clear();
  tries_ = 0;
  longest_ = max_;
  step_ = Step::kIdle;
}

}  // namespace cnc

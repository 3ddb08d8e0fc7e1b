// The wire's side of the core's model, one transaction at a time.

#include "tests/hal/stm32f405/usb/otg_model.hpp"

#include <algorithm>

#include "tests/hal/stm32f405/usb/otg_bits.hpp"

namespace hal::stm32f405 {

using namespace otg_bits;  // NOLINT(google-build-using-namespace): this file uses these names.

void OtgModel::enter(unsigned kind, unsigned endpoint, const Bytes& bytes) {
  Entry entry;
  entry.status = endpoint | static_cast<std::uint32_t>(bytes.size()) << 4 | kind << 17;
  entry.words.resize(words_for(bytes.size()));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    entry.words[at / 4] |= static_cast<std::uint32_t>(bytes[at]) << at % 4 * 8;
  }
  entries_.push_back(entry);
}

bool OtgModel::attached() const {
  return (device_control_ & 2U) == 0 && (general_ & one(16)) != 0 && (general_ & one(21)) != 0 &&
         (device_ & 3U) == 3;
}

bool OtgModel::hears(unsigned address) const {
  return attached() && !suspended_ && address_ == address;
}

void OtgModel::bus_reset() {
  suspended_ = false;
  set_up_ends_ = false;
  latched_ |= kUsbRst | kEnumDne;
  for (unsigned i = 0; i < kEndpoints; ++i) {
    in_[i].data1 = out_[i].data1 = false;
    in_[i].control |= kEpNakking;
    out_[i].control |= kEpNakking;
  }
  // The driver must clear the address: the core does not do it at a bus reset.
}

void OtgModel::suspend() {
  suspended_ = true;
  latched_ |= kUsbSusp;
}

void OtgModel::resume() {
  suspended_ = false;
  latched_ |= kWkup;
}

OtgModel::Shake OtgModel::set_up(unsigned address, const std::array<std::uint8_t, 8>& request) {
  if (!hears(address)) return Shake::kSilence;
  if (memory_used() + 4 > receive_words_) return Shake::kSilence;
  std::uint32_t& size = out_[0].size;
  if (size >> 29 == 0) {
    blame("no room for a request");
    return Shake::kSilence;
  }
  size -= one(29);
  for (Endpoint* endpoint : {in_.data(), out_.data()}) {
    endpoint->control = (endpoint->control & ~kEpStall) | kEpNakking;
    endpoint->data1 = true;
  }
  enter(kSetUpEntry, 0, {request.begin(), request.end()});
  set_up_ends_ = true;
  return Shake::kAck;
}

/// The end of a SETUP stage is recorded with the first token after it.
void OtgModel::end_set_up() {
  if (!set_up_ends_) return;
  set_up_ends_ = false;
  enter(kSetUpOverEntry, 0, {});
}

OtgModel::Shake OtgModel::out(unsigned address, unsigned number, bool data1, const Bytes& bytes) {
  if (!hears(address)) return Shake::kSilence;
  Endpoint& endpoint = out_[number];
  if (number == 0) end_set_up();
  if ((endpoint.control & kEpActive) == 0) return Shake::kSilence;
  if ((endpoint.control & kEpStall) != 0) return Shake::kStall;
  const bool ready = (endpoint.control & kEpEnabled) != 0 && (endpoint.control & kEpNakking) == 0;
  if (!ready || memory_used() + 2 + words_for(bytes.size()) > receive_words_) return Shake::kNak;
  // A repeated packet: its acknowledgement was lost.
  if (data1 != endpoint.data1) return Shake::kAck;
  if (bytes.size() > bytes_left(endpoint.size)) {
    blame("a packet that its transfer has no room for");
    return Shake::kNak;
  }
  endpoint.data1 = !endpoint.data1;
  endpoint.size -= one(19) + static_cast<std::uint32_t>(bytes.size());
  enter(kOutEntry, number, bytes);
  if (packets_of(endpoint.size) == 0 || bytes.size() < max_bytes(endpoint, number)) {
    endpoint.control |= kEpNakking;
    enter(kOutOverEntry, number, {});
  }
  return Shake::kAck;
}

OtgModel::Fetched OtgModel::in(unsigned address, unsigned number, bool acknowledged) {
  if (!hears(address)) return {};
  Endpoint& endpoint = in_[number];
  if (number == 0) end_set_up();
  if ((endpoint.control & kEpActive) == 0) return {};
  if ((endpoint.control & kEpStall) != 0) return {Shake::kStall};
  const std::size_t bytes = std::min(bytes_left(endpoint.size), max_bytes(endpoint, number));
  const bool ready = (endpoint.control & kEpEnabled) != 0 && (endpoint.control & kEpNakking) == 0;
  if (!ready || endpoint.fifo.size() < words_for(bytes)) return {Shake::kNak};
  Fetched fetched{Shake::kAck, endpoint.data1, Bytes(bytes)};
  for (std::size_t at = 0; at < bytes; ++at) {
    fetched.bytes[at] = static_cast<std::uint8_t>(endpoint.fifo[at / 4] >> at % 4 * 8);
  }
  if (!acknowledged) return fetched;
  endpoint.fifo.erase(endpoint.fifo.begin(),
                      endpoint.fifo.begin() + static_cast<std::ptrdiff_t>(words_for(bytes)));
  endpoint.data1 = !endpoint.data1;
  endpoint.size -= one(19) + static_cast<std::uint32_t>(bytes);
  if (packets_of(endpoint.size) == 0) {
    endpoint.control = (endpoint.control & ~kEpEnabled) | kEpNakking;
    endpoint.status |= kEpXfrc;
  }
  // A new address applies from the end of the request that set it.
  if (number == 0) address_ = device_ >> 4 & 0x7FU;
  return fetched;
}

}  // namespace hal::stm32f405

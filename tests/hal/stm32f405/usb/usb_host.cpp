#include "tests/hal/stm32f405/usb/usb_host.hpp"

#include <algorithm>
#include <cstddef>

namespace hal::stm32f405 {
namespace {

constexpr std::size_t kFullPacket = 64;

UsbHost::Bytes slice(const UsbHost::Bytes& bytes, std::size_t from, std::size_t most) {
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(from, bytes.size()));
  const std::size_t left = bytes.size() - std::min(from, bytes.size());
  return {begin, begin + static_cast<std::ptrdiff_t>(std::min(left, most))};
}

}  // namespace

void UsbHost::between() {
  if (chance(manner_.device_turns_percent)) turn_();
}

bool UsbHost::available() {
  if (left_ == 0) return false;
  if (left_ > 0) --left_;
  ++transactions_;
  return true;
}

void UsbHost::reset_bus() {
  core_.bus_reset();
  address_ = 0;
  forget_data_toggles();
  turn_();
}

bool UsbHost::request_stage(const Request& request) {
  int accepted = 0;
  for (int tries = 0; tries < kTries && available(); ++tries) {
    last_ = core_.set_up(address_, request);
    between();
    if (last_ != Shake::kAck) continue;
    // If the answer is lost, the host repeats the same request, up to three times.
    if (++accepted == 3 || !chance(manner_.lost_answers_percent)) return true;
  }
  return false;
}

bool UsbHost::out_stage(unsigned endpoint, bool& data1, const Bytes& bytes) {
  for (int tries = 0; tries < kTries && available(); ++tries) {
    last_ = core_.out(address_, endpoint, data1, bytes);
    between();
    if (last_ == Shake::kStall) return false;
    if (last_ == Shake::kAck && !chance(manner_.lost_answers_percent)) {
      data1 = !data1;
      return true;
    }
    if (last_ == Shake::kNak) turn_();
  }
  return false;
}

std::optional<UsbHost::Bytes> UsbHost::in_stage(unsigned endpoint, bool& data1) {
  for (int tries = 0; tries < kTries && available(); ++tries) {
    const OtgModel::Fetched fetched =
        core_.in(address_, endpoint, !chance(manner_.lost_answers_percent));
    last_ = fetched.shake;
    between();
    if (last_ == Shake::kStall) return std::nullopt;
    if (last_ == Shake::kAck && fetched.data1 == data1) {
      data1 = !data1;
      return fetched.bytes;
    }
    if (last_ == Shake::kNak) turn_();
  }
  return std::nullopt;
}

std::optional<UsbHost::Bytes> UsbHost::ask(Request request) {
  if (!request_stage(request)) return std::nullopt;
  const std::size_t wanted = request[6] + 256U * request[7];
  Bytes all;
  bool data1 = true;
  while (all.size() < wanted) {
    const std::optional<Bytes> packet = in_stage(0, data1);
    if (!packet) return std::nullopt;
    all.insert(all.end(), packet->begin(), packet->end());
    if (packet->size() < kFullPacket) break;
  }
  bool nod = true;
  if (wanted == 0) {
    if (!in_stage(0, nod)) return std::nullopt;
  } else if (!out_stage(0, nod, {})) {
    return std::nullopt;
  }
  return all;
}

bool UsbHost::tell(Request request, const Bytes& data) {
  if (!request_stage(request)) return false;
  bool data1 = true;
  for (std::size_t at = 0; at < data.size(); at += kFullPacket) {
    if (!out_stage(0, data1, slice(data, at, kFullPacket))) return false;
  }
  bool nod = true;
  const std::optional<Bytes> nodded = in_stage(0, nod);
  return nodded && nodded->empty();
}

UsbHost::Shake UsbHost::send(const Bytes& packet) {
  if (!available()) return Shake::kSilence;
  last_ = core_.out(address_, 1, data_out_, packet);
  between();
  if (last_ != Shake::kAck) return last_;
  if (chance(manner_.lost_answers_percent)) return Shake::kSilence;
  data_out_ = !data_out_;
  return last_;
}

std::optional<UsbHost::Bytes> UsbHost::fetch() {
  if (!available()) return std::nullopt;
  const OtgModel::Fetched fetched = core_.in(address_, 1, !chance(manner_.lost_answers_percent));
  last_ = fetched.shake;
  between();
  if (last_ != Shake::kAck || fetched.data1 != data_in_) return std::nullopt;
  data_in_ = !data_in_;
  return fetched.bytes;
}

bool UsbHost::send_all(const Bytes& bytes) {
  for (std::size_t at = 0; at < bytes.size(); at += kFullPacket) {
    if (!out_stage(1, data_out_, slice(bytes, at, kFullPacket))) return false;
  }
  return true;
}

UsbHost::Bytes UsbHost::fetch_transfer() {
  Bytes all;
  for (int packets = 0; packets < 1000; ++packets) {
    const std::optional<Bytes> packet = fetch();
    if (!packet) break;
    all.insert(all.end(), packet->begin(), packet->end());
    if (packet->size() < kFullPacket) break;
  }
  return all;
}

/// hub.c reads 64 bytes of the device descriptor at address 0, resets again, sets the address, and
/// reads the whole descriptor. Then it reads the head of the configuration, the whole configuration
/// and the strings. cdc_acm sets 9600 8N1.
bool UsbHost::enumerate() {
  reset_bus();
  if (!ask(request(0x80, 6, 0x100, 0, 64))) return false;
  reset_bus();
  constexpr unsigned kAddress = 23;
  if (!tell(request(0x00, 5, kAddress, 0, 0))) return false;
  address_ = kAddress;
  const auto read = [this](unsigned value, unsigned index, unsigned length, Bytes& into) {
    const std::optional<Bytes> got = ask(request(0x80, 6, value, index, length));
    if (got) into = *got;
    return got.has_value();
  };
  Bytes head;
  if (!read(0x100, 0, 18, device_descriptor) || !read(0x200, 0, 9, head) || head.size() != 9) {
    return false;
  }
  if (!read(0x200, 0, head[2] + 256U * head[3], configuration_descriptor)) return false;
  if (!read(0x300, 0, 255, strings[0])) return false;
  for (const unsigned index : {2U, 1U, 3U}) {
    if (!read(0x300 + index, 0x409, 255, strings[index])) return false;
  }
  if (!tell(request(0x00, 9, 1, 0, 0))) return false;
  forget_data_toggles();
  return tell(request(0x21, 0x20, 0, 0, 7), {0x80, 0x25, 0, 0, 0, 0, 8});
}

bool UsbHost::open() { return tell(request(0x21, 0x22, 3, 0, 0)); }
bool UsbHost::close() { return tell(request(0x21, 0x22, 0, 0, 0)); }

}  // namespace hal::stm32f405

#include "firmware/link/can/lss_slave.hpp"

#include "firmware/link/can/can_identifiers.hpp"

namespace cnc {
namespace {

/// Command, the first byte of a frame (CiA 305, 3.9).
enum class Command : std::uint8_t {
  kSwitchAll = 0x04,
  kConfigureNode = 0x11,
  kConfigureBitRate = 0x13,
  kStore = 0x17,
  kSelectVendor = 0x40,  ///< The next three codes select by product, revision and serial number.
  kSelectSerial = 0x43,
  kSelected = 0x44,
  kIdentifyVendor = 0x46,  ///< First of six codes, one for each bound of the identity.
  kIdentifySerialEnd = 0x4B,
  kIdentified = 0x4F,
  kAskVendor = 0x5A,
  kAskSerial = 0x5D,
  kAskNode = 0x5E,
};

constexpr std::uint8_t kOk = 0;
constexpr std::uint8_t kOutOfRange = 1;  ///< The node number or bit rate is out of range.
constexpr std::uint8_t kNoAccess = 2;    ///< The store cannot be accessed.
constexpr std::size_t kParts = 4;
constexpr std::size_t kBounds = 6;

LssSlave::Payload answer(Command command, std::uint32_t number = 0) {
  LssSlave::Payload payload{static_cast<std::byte>(command)};
  for (std::size_t at = 0; at < 4; ++at) {
    payload[1 + at] = static_cast<std::byte>(number >> (8 * at) & 0xFFU);
  }
  return payload;
}

std::uint32_t number_in(std::span<const std::byte> payload) {
  std::uint32_t number = 0;
  for (std::size_t at = 4; at > 0; --at) {
    number = number << 8 | std::to_integer<std::uint32_t>(payload[at]);
  }
  return number;
}

}  // namespace

std::optional<LssSlave::Payload> LssSlave::take(std::span<const std::byte> payload,
                                                std::uint8_t node) {
  if (payload.size() != Payload{}.size()) return std::nullopt;
  const auto code = std::to_integer<std::uint8_t>(payload[0]);
  const std::uint32_t number = number_in(payload);
  const auto from = [code](Command first) {
    return static_cast<std::size_t>(code - static_cast<std::uint8_t>(first));
  };
  const auto command = static_cast<Command>(code);
  if (command == Command::kSwitchAll) {
    switch_mode(payload[1] == std::byte{1});
  } else if (command >= Command::kSelectVendor && command <= Command::kSelectSerial) {
    if (is_selected(from(Command::kSelectVendor), number)) return answer(Command::kSelected);
  } else if (command >= Command::kIdentifyVendor && command <= Command::kIdentifySerialEnd) {
    if (is_within(from(Command::kIdentifyVendor), number)) return answer(Command::kIdentified);
  } else if (!configured_now_) {
    return std::nullopt;
  } else if (command == Command::kConfigureNode) {
    return configure_node(std::to_integer<std::uint8_t>(payload[1]));
  } else if (command == Command::kConfigureBitRate) {
    return answer(command, kOutOfRange);
  } else if (command == Command::kStore) {
    // No other number was set, and the present number is already stored.
    if (node_ == 0) return stored(true);
    store_ = true;
  } else if (command >= Command::kAskVendor && command <= Command::kAskSerial) {
    return answer(command, identity_[from(Command::kAskVendor)]);
  } else if (command == Command::kAskNode) {
    return answer(command, node_ != 0 ? node_ : node);
  }
  return std::nullopt;
}

LssSlave::Payload LssSlave::stored(bool ok) {
  return answer(Command::kStore, ok ? kOk : kNoAccess);
}

void LssSlave::switch_mode(bool configure) {
  configured_now_ = configure;
  selected_ = 0;
}

/// Compares `number` with part `part` of the identity. If all parts have matched in order,
/// beginning with the vendor, selects the controller and returns true.
bool LssSlave::is_selected(std::size_t part, std::uint32_t number) {
  const bool next = part == 0 || part == selected_;
  selected_ = next && identity_[part] == number ? part + 1 : 0;
  if (selected_ != kParts) return false;
  switch_mode(true);
  return true;
}

/// Checks the identity against bound number `bound`, whose value is `number`. Returns whether the
/// identity is within all bounds. The bounds must arrive in this order: vendor, product, minimum
/// and maximum revision, minimum and maximum serial number.
bool LssSlave::is_within(std::size_t bound, std::uint32_t number) {
  constexpr std::array<std::size_t, kBounds> kPartOf{0, 1, 2, 2, 3, 3};
  const std::uint32_t own = identity_[kPartOf[bound]];
  const bool least = bound == 2 || bound == 4;
  const bool greatest = bound == 3 || bound == 5;
  const bool fits = least ? own >= number : greatest ? own <= number : own == number;
  const bool next = bound == 0 || bound == within_;
  within_ = next && fits ? bound + 1 : 0;
  return within_ == kBounds;
}

LssSlave::Payload LssSlave::configure_node(std::uint8_t node) {
  const bool ok = node >= 1 && node <= can::kLastNode;
  if (ok) node_ = node;
  return answer(Command::kConfigureNode, ok ? kOk : kOutOfRange);
}

}  // namespace cnc

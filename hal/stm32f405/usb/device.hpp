#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/stm32f405/usb/descriptors.hpp"
#include "hal/stm32f405/usb/set_up.hpp"

namespace hal::stm32f405::usb {

/// Action that the caller must carry out after a request, in addition to sending data.
enum class Effect : std::uint8_t {
  kNone,
  kAddress,    ///< Use `address()` from now on.
  kConfigure,  ///< Restart the data endpoints; stop them if `configured()` is false.
  kHalt,       ///< Stall the endpoint `endpoint`.
  kUnhalt,     ///< End the stall of `endpoint` and restart it with DATA0.
  kLineState,  ///< `line_is_open()` may have changed.
};

struct Answer {
  enum class Kind : std::uint8_t { kStall, kDone, kSend, kReceive };

  Kind kind = Kind::kStall;  ///< Initially the answer to an unknown request: a stall.
  Effect effect = Effect::kNone;
  std::uint8_t endpoint = 0;          ///< Number of the endpoint; bit 7 is set for an IN endpoint.
  std::span<const std::byte> data{};  ///< Data to send, at most the requested number of bytes.
};

/// Computes the answers of a USB serial line to the requests of the host, without access to
/// registers. Used in one context at a time.
class Device {
 public:
  static constexpr std::size_t kLineCodingBytes = 7;

  /// Sets the identity. Called once.
  /// @param maker,product zero-terminated texts of at most kLongestString letters; they are not
  ///     copied
  constexpr void introduce(const Identity& identity, const char* maker, const char* product) {
    descriptor_ = device_descriptor(identity);
    maker_ = maker;
    product_ = product;
  }
  /// Sets the serial number.
  /// @param serial 96 bits that are unique among devices of this kind
  constexpr void set_serial(const std::array<std::uint32_t, 3>& serial) { serial_ = serial; }

  /// Restores the state after power-on; the identity and the serial number stay.
  constexpr void reset() {
    address_ = configuration_ = 0;
    halted_ = 0;
    line_is_open_ = false;
  }

  [[nodiscard]] constexpr Answer answer(const SetUp& asked) {
    return asked.to_host() ? tell(asked) : obey(asked);
  }
  /// Stores the data of a request that was answered by kReceive.
  constexpr void take_data(std::span<const std::byte> data) {
    for (std::size_t at = 0; at < data.size() && at < kLineCodingBytes; ++at) {
      line_coding_[at] = data[at];
    }
  }

  [[nodiscard]] constexpr std::uint8_t address() const { return address_; }
  [[nodiscard]] constexpr bool configured() const { return configuration_ != 0; }
  /// Returns whether a program on the host has opened the line, which the host reports by DTR.
  [[nodiscard]] constexpr bool line_is_open() const { return line_is_open_; }

 private:
  static constexpr std::size_t kLongestString = 63;
  static constexpr std::uint16_t kDataTerminalReady = 1;
  static constexpr std::uint8_t kIn = 0x80;

  constexpr Answer tell(const SetUp& asked) {
    switch (request_of(asked)) {
      case request::kDescriptor:
        return send(descriptor(asked), asked);
      case request::kDeviceStatus:
        return send(two_bytes(1), asked);  // The value 1 means that the device has its own supply.
      case request::kInterfaceStatus:
        if (!configured() || asked.index >= kInterfaces) return {};
        return send(two_bytes(0), asked);
      case request::kEndpointStatus:
        if (!has_endpoint(asked.index)) return {};
        return send(two_bytes((halted_ & mark(asked.index)) != 0 ? 1 : 0), asked);
      case request::kConfigurationInUse:
        scratch_[0] = static_cast<std::byte>(configuration_);
        return send(std::span{scratch_}.first(1), asked);
      case request::kAlternateInUse:
        if (!configured() || asked.index >= kInterfaces) return {};
        scratch_[0] = std::byte{0};
        return send(std::span{scratch_}.first(1), asked);
      case request::kLineCoding:
        return asked.index == 0 ? send(line_coding_, asked) : Answer{};
      default:
        return {};
    }
  }

  constexpr Answer obey(const SetUp& asked) {
    if (request_of(asked) == request::kSetLineCoding) {
      if (!configured() || asked.index != 0 || asked.length != kLineCodingBytes) return {};
      return {.kind = Answer::Kind::kReceive};
    }
    if (asked.length != 0) return {};
    switch (request_of(asked)) {
      case request::kSetAddress:
        if (asked.value > 127 || configured()) return {};
        address_ = static_cast<std::uint8_t>(asked.value);
        return done(Effect::kAddress);
      case request::kConfigure:
        if (asked.value > kOnlyConfiguration) return {};
        configuration_ = static_cast<std::uint8_t>(asked.value);
        halted_ = 0;
        line_is_open_ = false;
        return done(Effect::kConfigure);
      case request::kSetEndpoint:
      case request::kClearEndpoint:
        return halt(asked, request_of(asked) == request::kSetEndpoint);
      case request::kSetLineState:
        if (!configured() || asked.index != 0) return {};
        line_is_open_ = (asked.value & kDataTerminalReady) != 0;
        return done(Effect::kLineState);
      default:
        return {};
    }
  }

  constexpr Answer halt(const SetUp& asked, bool halted) {
    if (asked.value != 0 || !has_endpoint(asked.index)) return {};
    if ((asked.index & 0xFU) == 0) return done(Effect::kNone);
    halted_ = static_cast<std::uint8_t>(halted ? halted_ | mark(asked.index)
                                               : halted_ & ~mark(asked.index));
    Answer given = done(halted ? Effect::kHalt : Effect::kUnhalt);
    given.endpoint = static_cast<std::uint8_t>(asked.index);
    return given;
  }

  [[nodiscard]] constexpr bool has_endpoint(std::uint16_t index) const {
    if ((index & 0x7FU) == 0) return index <= kIn;
    if (!configured()) return false;
    return index == kData || index == (kIn | kData) || index == (kIn | kNews);
  }
  /// Returns the bit of an endpoint in `halted_`.
  static constexpr std::uint8_t mark(std::uint16_t index) {
    return static_cast<std::uint8_t>(1U << ((index & 3U) + ((index & kIn) != 0 ? 4U : 0U)));
  }

  constexpr std::span<const std::byte> descriptor(const SetUp& asked) {
    const unsigned index = asked.value & 0xFFU;
    switch (static_cast<DescriptorType>(asked.value >> 8)) {
      case DescriptorType::kDevice:
        return index == 0 ? std::span<const std::byte>{descriptor_} : std::span<const std::byte>{};
      case DescriptorType::kConfiguration:
        return index == 0 ? std::span<const std::byte>{kConfigurationDescriptor}
                          : std::span<const std::byte>{};
      case DescriptorType::kString:
        return string(static_cast<StringIndex>(index));
      default:
        // The device has no other descriptors, for example no device qualifier, which only
        // high-speed devices have.
        return {};
    }
  }

  constexpr std::span<const std::byte> string(StringIndex index) {
    std::size_t letters = 0;
    const auto add = [&](char letter) {
      scratch_[2 + 2 * letters] = static_cast<std::byte>(letter);
      scratch_[3 + 2 * letters] = std::byte{0};
      ++letters;
    };
    switch (index) {
      case StringIndex::kLanguages:
        return kLanguages;
      case StringIndex::kMaker:
      case StringIndex::kProduct: {
        const char* text = index == StringIndex::kMaker ? maker_ : product_;
        while (*text != '\0' && letters < kLongestString) add(*text++);
        break;
      }
      case StringIndex::kSerial:
        for (unsigned digit = 0; digit < 24; ++digit) {
          add("0123456789ABCDEF"[serial_[digit / 8] >> (28 - 4 * (digit % 8)) & 0xFU]);
        }
        break;
      default:
        return {};
    }
    scratch_[0] = static_cast<std::byte>(2 + 2 * letters);
    scratch_[1] = static_cast<std::byte>(DescriptorType::kString);
    return std::span{scratch_}.first(2 + 2 * letters);
  }

  constexpr std::span<const std::byte> two_bytes(int value) {
    scratch_[0] = static_cast<std::byte>(value);
    scratch_[1] = std::byte{0};
    return std::span{scratch_}.first(2);
  }

  static constexpr Answer send(std::span<const std::byte> data, const SetUp& asked) {
    if (data.empty()) return {};
    return {.kind = Answer::Kind::kSend,
            .data = data.first(data.size() < asked.length ? data.size() : asked.length)};
  }
  static constexpr Answer done(Effect effect) {
    return {.kind = Answer::Kind::kDone, .effect = effect};
  }

  decltype(device_descriptor({})) descriptor_{};
  const char* maker_ = "";
  const char* product_ = "";
  std::array<std::uint32_t, 3> serial_{};
  std::array<std::byte, 2 + 2 * kLongestString> scratch_{};
  /// 115,200 baud, 8N1: the value that a host reads before it has set another value.
  std::array<std::byte, kLineCodingBytes> line_coding_ = bytes_of(0x00, 0xC2, 0x01, 0, 0, 0, 8);
  std::uint8_t address_ = 0;
  std::uint8_t configuration_ = 0;
  std::uint8_t halted_ = 0;
  bool line_is_open_ = false;
};

}  // namespace hal::stm32f405::usb

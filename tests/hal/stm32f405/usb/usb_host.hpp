#pragma once

#include <array>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "tests/hal/stm32f405/usb/otg_model.hpp"

namespace hal::stm32f405 {

/// Model of a host's controller and driver: transactions with toggles, repeated after NAK and
/// silence; duplicates are dropped. Between transactions the device gets time to act, always or at
/// random.
class UsbHost {
 public:
  using Bytes = OtgModel::Bytes;
  using Shake = OtgModel::Shake;
  using Request = std::array<std::uint8_t, 8>;

  struct Manner {
    /// Percentage of transactions after which the device gets time to act.
    unsigned device_turns_percent = 100;
    /// Percentage of handshakes that are lost, in either direction.
    unsigned lost_answers_percent = 0;
  };

  UsbHost(OtgModel& core, std::function<void()> device_turn, std::uint64_t seed = 1)
      : core_{core}, turn_{std::move(device_turn)}, random_{seed} {}

  void set_manner(Manner manner) { manner_ = manner; }
  /// Unplugs the host after this number of transactions: all later ones get no answer.
  void cut_after(long transactions) { left_ = transactions; }
  [[nodiscard]] bool cut() const { return left_ == 0; }
  [[nodiscard]] long transactions() const { return transactions_; }
  [[nodiscard]] bool chance(unsigned percent) { return random_() % 100 < percent; }
  [[nodiscard]] unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }

  void reset_bus();

  /// Sends a request for data; returns nothing if it was stalled or never answered.
  std::optional<Bytes> ask(Request request);
  /// Sends a request with data for the device, or without data; returns false if it was stalled or
  /// never answered.
  bool tell(Request request, const Bytes& data = {});
  [[nodiscard]] bool stalled() const { return last_ == Shake::kStall; }

  // Bulk transfers: each call tries one packet once.
  Shake send(const Bytes& packet);
  /// Returns a packet; nothing if there is none, or only a repeated one.
  std::optional<Bytes> fetch();
  /// Sends all bytes, and repeats each packet until it is accepted; returns false if one never was.
  bool send_all(const Bytes& bytes);
  /// Returns the data up to the first packet that is not full.
  Bytes fetch_transfer();

  /// Enumerates from reset to configured, in the order of Linux's hub and cdc_acm drivers. Returns
  /// false at the first request that fails.
  bool enumerate();
  bool open();
  bool close();
  void forget_data_toggles() { data_in_ = data_out_ = false; }
  [[nodiscard]] unsigned address() const { return address_; }

  Bytes device_descriptor;
  Bytes configuration_descriptor;
  std::array<Bytes, 4> strings;

 private:
  static constexpr int kTries = 400;

  void between();
  [[nodiscard]] bool available();
  bool request_stage(const Request& request);
  bool out_stage(unsigned endpoint, bool& data1, const Bytes& bytes);
  std::optional<Bytes> in_stage(unsigned endpoint, bool& data1);

  OtgModel& core_;
  std::function<void()> turn_;
  std::mt19937 random_;
  Manner manner_{};
  long left_ = -1;
  long transactions_ = 0;
  unsigned address_ = 0;
  bool data_in_ = false;
  bool data_out_ = false;
  Shake last_ = Shake::kAck;
};

constexpr UsbHost::Request request(
    unsigned type, unsigned number, unsigned value, unsigned index, unsigned length) {
  const auto byte = [](unsigned bits) { return static_cast<std::uint8_t>(bits & 0xFFU); };
  return {byte(type),
          byte(number),
          byte(value),
          byte(value >> 8),
          byte(index),
          byte(index >> 8),
          byte(length),
          byte(length >> 8)};
}

}  // namespace hal::stm32f405

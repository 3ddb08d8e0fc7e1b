#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/target/machine/gpio.hpp"
#include "tests/target/machine/virtual_clock.hpp"

namespace machine {

struct PinChange {
  std::int64_t at_ns = 0;
  char port = 'A';
  unsigned pin = 0;
  Gpio::Wire wire = Gpio::Wire::kFree;
};

/// Reads lines `NS P<port><pin> 0|1|z` in order of time; returns false with a message if a line is
/// not valid.
[[nodiscard]] bool read_pin_script(const std::string& path, std::vector<PinChange>& changes);

/// Applies such a file to the ports.
class PinScript {
 public:
  template <typename Ports>
  PinScript(const std::vector<PinChange>& changes, Ports& ports)
      : changes_{changes}, alarm_{[this, &ports] { play(ports); }} {
    if (!changes_.empty()) alarm_.set(changes_.front().at_ns);
  }

 private:
  template <typename Ports>
  void play(Ports& ports) {
    while (next_ < changes_.size() && changes_[next_].at_ns <= now_ns()) {
      const PinChange& change = changes_[next_++];
      ports[static_cast<std::size_t>(change.port - 'A')].connect(change.pin, change.wire);
    }
    if (next_ < changes_.size()) alarm_.set(changes_[next_].at_ns);
  }

  const std::vector<PinChange>& changes_;
  std::size_t next_ = 0;
  Alarm alarm_;
};

}  // namespace machine

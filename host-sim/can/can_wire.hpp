#pragma once

#include <poll.h>

#include <string>
#include <string_view>
#include <vector>

#include "hal/interface/can_port.hpp"

namespace sim {

/// A bus that a node of ours is on, whatever it is made of.
class CanWire {
 public:
  CanWire() = default;
  CanWire(const CanWire&) = delete;
  CanWire& operator=(const CanWire&) = delete;
  virtual ~CanWire() = default;

  [[nodiscard]] virtual hal::CanPort& port() = 0;
  /// Carries frames between the port and the outside, without blocking.
  virtual void carry() = 0;
  /// Adds what to wake up for.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
  /// False where the way to the bus is gone.
  [[nodiscard]] virtual bool up() const { return true; }
  /// `can` or `slcan`.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  /// Where others find the bus.
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace sim

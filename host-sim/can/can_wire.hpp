#pragma once

#include <poll.h>

#include <string>
#include <string_view>
#include <vector>

#include "hal/interface/can_port.hpp"

namespace sim {

/// A CAN bus on which this program has a node or a host, through any kind of interface.
class CanWire {
 public:
  CanWire() = default;
  CanWire(const CanWire&) = delete;
  CanWire& operator=(const CanWire&) = delete;
  virtual ~CanWire() = default;

  [[nodiscard]] virtual hal::CanPort& port() = 0;
  /// Moves frames between the port and the bus, without blocking.
  virtual void carry() = 0;
  /// Adds the descriptors and events for which poll() is to wake up.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
  /// Returns false once the connection to the bus is lost.
  [[nodiscard]] virtual bool up() const { return true; }
  /// Returns `can` or `slcan`.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  /// Returns the address at which other programs find the bus.
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace sim

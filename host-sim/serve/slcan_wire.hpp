#pragma once

#include "hal/host/slcan.hpp"
#include "host-sim/can/can_wire.hpp"
#include "host-sim/serve/pty_transport.hpp"

namespace sim {

/// A pseudo terminal that behaves like a CAN adapter on a serial port (slcan).
class SlcanWire final : public CanWire {
 public:
  /// Throws as PtyLink::point_to() does.
  explicit SlcanWire(const std::string& link);

  [[nodiscard]] hal::CanPort& port() override { return slcan_; }
  void carry() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "slcan"; }
  [[nodiscard]] std::string address() const override { return link_.path(); }

 private:
  PtyMaster master_;
  PtyLink link_;
  hal::host::Slcan slcan_{};
  bool used_ = false;
};

}  // namespace sim

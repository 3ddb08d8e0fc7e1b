#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "firmware/link/can/can_link.hpp"
#include "host-sim/can/can_wire.hpp"
#include "host-sim/serve/transport.hpp"

namespace sim {

/// The served controller as a node of a CAN bus. It runs the link of the controller's firmware
/// (cnc::CanLink) on the clock of this machine.
class CanTransport final : public Transport {
 public:
  /// Functions through which the link accesses the controller. The link reads the state of the
  /// controller in each call of attend().
  struct Controller {
    std::function<cnc::CanLink::Condition()> condition;
    std::function<std::uint8_t()> node;  ///< Returns the node number from the settings.
    /// Stores the node number in the settings; returns false if that is impossible at present.
    std::function<bool(std::uint8_t)> store_node;
  };

  /// @param speed controller seconds per second
  CanTransport(std::unique_ptr<CanWire> wire, Controller controller, double speed);

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override { wire_->add_to(descriptors); }
  [[nodiscard]] std::string_view kind() const override { return wire_->kind(); }
  /// Returns the address of the bus and the node number: `LINK node 17`.
  [[nodiscard]] std::string address() const override;
  [[nodiscard]] bool take_stop() override;

 private:
  class Sender;

  using Clock = std::chrono::steady_clock;

  void attend();
  void pass_time();

  std::unique_ptr<CanWire> wire_;
  Controller controller_;
  cnc::CanLink link_;
  double speed_;
  Clock::time_point looked_ = Clock::now();
  hal::TickCount now_{};        ///< Time of the link.
  std::uint32_t accepted_ = 0;  ///< Number of the last sender's session.
};

}  // namespace sim

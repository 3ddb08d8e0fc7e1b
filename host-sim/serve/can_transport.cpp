#include "host-sim/serve/can_transport.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sim {

/// Connection of the host that has a session with the controller. The connection ends with the
/// session.
class CanTransport::Sender final : public Connection {
 public:
  explicit Sender(CanTransport& transport)
      : transport_{transport}, session_{transport.link_.session()} {}

  std::size_t read(std::span<std::byte> into) override {
    transport_.attend();
    return talks() ? transport_.link_.read(into) : 0;
  }
  std::size_t write(std::span<const std::byte> from) override {
    const std::size_t count = talks() ? transport_.link_.write(from) : 0;
    transport_.attend();
    return count;
  }
  bool take_realtime(std::byte& byte) override {
    return talks() && transport_.link_.take_realtime(byte);
  }
  bool open() override {
    transport_.attend();
    return talks();
  }
  void end() override {}
  // CanTransport::add_to() adds the descriptors of the bus.
  void add_to(std::vector<pollfd>&, Wishes) const override {}

 private:
  [[nodiscard]] bool talks() const { return transport_.link_.session() == session_; }

  CanTransport& transport_;
  std::uint32_t session_;
};

/// Uses the node number as the serial number, so that simulated controllers on one bus differ.
CanTransport::CanTransport(std::unique_ptr<CanWire> wire, Controller controller, double speed)
    : wire_{std::move(wire)},
      controller_{std::move(controller)},
      link_{wire_->port(), controller_.node(), {.serial = controller_.node()}},
      speed_{speed} {}

void CanTransport::attend() {
  wire_->carry();
  link_.tell(controller_.condition());
  link_.want_node(controller_.node());
  pass_time();
  link_.attend(now_);
  if (const std::uint8_t node = link_.take_node_to_store()) {
    link_.note_stored(controller_.store_node(node));
  }
  wire_->carry();
}

/// Advances the time of the link. If this process was suspended on a busy machine, the host may
/// have waited for the same processor. So at most kUsual of the elapsed time counts as silence of
/// the host. If the controller's time runs faster than real time, the host is not faster. So its
/// silence is divided by the speed.
void CanTransport::pass_time() {
  using std::chrono::microseconds;
  // Greatest time that counts as silence, slightly more than a cycle.
  constexpr microseconds kUsual{2000};
  const auto looked = Clock::now();
  const auto away = std::chrono::floor<microseconds>(looked - looked_);
  looked_ += away;
  const auto silent = static_cast<double>(std::min(away, kUsual).count()) / std::max(1.0, speed_);
  const auto passed = static_cast<std::uint32_t>(away.count());
  now_ = now_.plus(passed);
  link_.excuse_host(passed - static_cast<std::uint32_t>(silent));
}

std::unique_ptr<Connection> CanTransport::accept() {
  attend();
  if (link_.session() == 0 || link_.session() == accepted_) return nullptr;
  accepted_ = link_.session();
  return std::make_unique<Sender>(*this);
}

bool CanTransport::take_stop() {
  attend();
  return link_.take_stop();
}

std::string CanTransport::address() const {
  return fmt::format("{} node {}", wire_->address(), link_.node());
}

}  // namespace sim

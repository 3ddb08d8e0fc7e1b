#include "host-sim/serve/can_transport.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sim {

/// Whoever has a session, until it is over.
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
  void add_to(std::vector<pollfd>&, Wishes) const override {}  // The bus wakes us anyway.

 private:
  [[nodiscard]] bool talks() const { return transport_.link_.session() == session_; }

  CanTransport& transport_;
  std::uint32_t session_;
};

CanTransport::CanTransport(std::unique_ptr<CanWire> wire,
                           std::uint8_t node,
                           std::function<Condition()> condition)
    : wire_{std::move(wire)}, link_{wire_->port(), node}, condition_{std::move(condition)} {}

void CanTransport::attend() {
  wire_->carry();
  link_.tell(condition_());
  pass_time();
  link_.attend(now_);
  wire_->carry();
}

/// Who was away itself, on a machine that had other things to do, cannot tell that others were
/// silent: what they have said meanwhile may not have come yet.
void CanTransport::pass_time() {
  using std::chrono::microseconds;
  constexpr microseconds kMostAway{20'000};
  const auto looked = Clock::now();
  const auto away = std::chrono::floor<microseconds>(looked - looked_);
  looked_ += away;
  now_ = now_.plus(static_cast<std::uint32_t>(std::min(away, kMostAway).count()));
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

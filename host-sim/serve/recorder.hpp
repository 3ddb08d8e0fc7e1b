#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/serve/conversation.hpp"
#include "host-sim/serve/live_link.hpp"

namespace sim {

/// Groups the bytes that pass over a link into exchanges: consecutive bytes of one direction and
/// one cycle become one exchange.
class Recorder final : public LinkListener {
 public:
  using Keep = std::function<void(const Exchange&)>;

  /// @param controller gives the time of the exchanges; must outlive this object
  Recorder(const VirtualController& controller, Keep keep)
      : controller_{controller}, keep_{std::move(keep)} {}

  void on_read(std::span<const std::byte> bytes) override { add(Exchange::Kind::kHeard, bytes); }
  void on_write(std::span<const std::byte> bytes) override { add(Exchange::Kind::kSaid, bytes); }
  void on_full() override { add(Exchange::Kind::kFull, {}); }
  void on_beside(std::byte byte) override { add(Exchange::Kind::kBeside, {&byte, 1}); }
  void on_stop() override { add(Exchange::Kind::kStop, {}); }

  /// Passes the last exchange to `keep`. Before this call, further bytes may still belong to it.
  void finish();

 private:
  void add(Exchange::Kind kind, std::span<const std::byte> bytes);

  const VirtualController& controller_;
  Keep keep_;
  Exchange open_{};
  bool is_open_ = false;
};

}  // namespace sim

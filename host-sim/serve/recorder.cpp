#include "host-sim/serve/recorder.hpp"

namespace sim {

void Recorder::add(Exchange::Kind kind, std::span<const std::byte> bytes) {
  const std::uint64_t now_ns = controller_.now_ticks() * VirtualController::kNanosecondsPerTick;
  if (is_open_ && (open_.kind != kind || open_.time_ns != now_ns)) finish();
  open_.kind = kind;
  open_.time_ns = now_ns;
  is_open_ = true;
  for (const std::byte byte : bytes) open_.bytes += static_cast<char>(byte);
}

void Recorder::finish() {
  if (is_open_) keep_(open_);
  is_open_ = false;
  open_ = {};
}

}  // namespace sim

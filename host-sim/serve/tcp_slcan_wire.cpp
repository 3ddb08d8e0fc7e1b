#include "host-sim/serve/tcp_slcan_wire.hpp"

#include <array>

namespace sim {

void TcpSlcanWire::carry() {
  if (!host_) host_ = listener_.accept();
  if (!host_) return;
  std::array<std::byte, 256> heard{};
  while (slcan_.can_hear()) {
    const std::size_t count = host_->read(heard);
    if (count == 0) break;
    slcan_.hear(std::span{heard}.first(count));
  }
  const std::string_view words = slcan_.to_say();
  slcan_.said(host_->write(std::as_bytes(std::span{words})));
  if (host_->open()) return;
  slcan_.close();
  host_.reset();
}

void TcpSlcanWire::add_to(std::vector<pollfd>& descriptors) const {
  if (!host_) return listener_.add_to(descriptors);
  host_->add_to(descriptors, {.read = slcan_.can_hear(), .write = !slcan_.to_say().empty()});
}

}  // namespace sim

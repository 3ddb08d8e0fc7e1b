#include "host-sim/serve/live_link.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace sim {
namespace {

template <typename Queue>
std::size_t move_out(Queue& queue, std::span<std::byte> into) {
  std::size_t count = 0;
  while (count < into.size() && !queue.empty()) {
    const std::span<const std::byte> front = queue.front();
    const std::size_t part = std::min(front.size(), into.size() - count);
    std::copy_n(front.begin(), part, into.begin() + static_cast<std::ptrdiff_t>(count));
    queue.pop(part);
    count += part;
  }
  return count;
}

}  // namespace

std::size_t LiveLink::read(std::span<std::byte> into) {
  std::size_t count = move_out(urgent_, into);
  count += move_out(incoming_, into.subspan(count));
  if (count != 0 && listener_ != nullptr) listener_->on_read(into.first(count));
  return count;
}

std::size_t LiveLink::write(std::span<const std::byte> from) {
  const std::size_t count = connected_ ? outgoing_.push(from) : from.size();
  if (listener_ == nullptr) return count;
  if (count != 0) listener_->on_write(from.first(count));
  if (count < from.size()) listener_->on_full();
  return count;
}

void LiveLink::disconnect() {
  connected_ = false;
  urgent_.clear();
  incoming_.clear();
  outgoing_.clear();
}

void LiveLink::receive(std::span<const std::byte> bytes) {
  const std::size_t count = incoming_.push(bytes);
  CNC_ASSERT(count == bytes.size());
}

void LiveLink::interject(std::byte byte) { urgent_.push({&byte, 1}); }

}  // namespace sim

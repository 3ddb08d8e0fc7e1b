#include "host-sim/serve/web_pipe.hpp"

#include <algorithm>

namespace sim {
namespace {

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

bool WebPipe::put(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [this] { return ended_ || incoming_.size() < kIncoming; });
      if (ended_) return false;
      const std::size_t count = std::min(bytes.size(), kIncoming - incoming_.size());
      incoming_ += as_text(bytes.first(count));
      bytes = bytes.subspan(count);
    }
    wake_();
  }
  return true;
}

std::optional<std::string> WebPipe::take() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return left_ || ended_ || !outgoing_.empty(); });
  if (left_ || outgoing_.empty()) return {};
  std::string message = std::move(outgoing_.front());
  outgoing_.pop_front();
  outgoing_bytes_ -= message.size();
  return message;
}

void WebPipe::leave() {
  {
    const std::lock_guard lock{mutex_};
    left_ = true;
  }
  changed_.notify_all();
  wake_();
}

std::size_t WebPipe::read(std::span<std::byte> into) {
  std::size_t count = 0;
  {
    const std::lock_guard lock{mutex_};
    count = std::min(into.size(), incoming_.size());
    const auto bytes = std::as_bytes(std::span{incoming_}).first(count);
    std::copy(bytes.begin(), bytes.end(), into.begin());
    incoming_.erase(0, count);
  }
  if (count != 0) changed_.notify_all();
  return count;
}

std::size_t WebPipe::write(std::span<const std::byte> from) {
  std::size_t count = 0;
  {
    const std::lock_guard lock{mutex_};
    if (left_ || ended_) return 0;
    count = std::min(from.size(), kOutgoing - outgoing_bytes_);
    if (count == 0) return 0;
    outgoing_.emplace_back(as_text(from.first(count)));
    outgoing_bytes_ += count;
  }
  changed_.notify_all();
  return count;
}

void WebPipe::end() {
  {
    const std::lock_guard lock{mutex_};
    ended_ = true;
  }
  changed_.notify_all();
}

bool WebPipe::open() const {
  const std::lock_guard lock{mutex_};
  return !left_ || !incoming_.empty();
}

std::size_t WebPipe::unsent() const {
  const std::lock_guard lock{mutex_};
  return outgoing_bytes_;
}

}  // namespace sim

#include "host-sim/send/can_port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "hal/host/slcan_host.hpp"
#include "host-sim/can/socket_can_wire.hpp"
#include "host-sim/send/serial_device.hpp"

namespace sim {
namespace {

namespace can = cnc::can;

/// Time of silence after which a node counts as not on the bus: four of its heartbeats.
constexpr std::chrono::milliseconds kNodeSilence{2000};
constexpr std::chrono::milliseconds kMaxAway{20};

/// The host's end of a CAN adapter on a serial port (slcan).
class SlcanHostWire final : public CanWire {
 public:
  SlcanHostWire(const std::string& device, unsigned baud)
      : device_{device}, terminal_{open_serial_device(device, baud)} {}
  SlcanHostWire(const SlcanHostWire&) = delete;
  SlcanHostWire& operator=(const SlcanHostWire&) = delete;
  ~SlcanHostWire() override {
    slcan_.close();
    carry();
  }

  hal::CanPort& port() override { return slcan_; }
  void carry() override {
    std::array<char, 1024> heard{};
    for (;;) {
      const ssize_t count = ::read(terminal_.number(), heard.data(), heard.size());
      if (count < 0 && errno == EIO) up_ = false;
      if (count <= 0) break;
      slcan_.hear(std::span{heard}.first(static_cast<std::size_t>(count)));
    }
    look_for_hang_up();
    const std::string_view words = slcan_.to_say();
    if (words.empty()) return;
    const ssize_t count = ::write(terminal_.number(), words.data(), words.size());
    if (count > 0) slcan_.said(static_cast<std::size_t>(count));
  }
  void add_to(std::vector<pollfd>& descriptors) const override {
    descriptors.push_back({terminal_.number(), POLLIN, 0});
  }
  bool up() const override { return up_; }
  std::string_view kind() const override { return "slcan"; }
  std::string address() const override { return device_; }

 private:
  /// Checks for a hang-up with poll(), because read() gives the same result for a serial port
  /// without data and for a disconnected port.
  void look_for_hang_up() {
    pollfd state{terminal_.number(), POLLIN, 0};
    if (::poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) {
      up_ = false;
    }
  }

  std::string device_;
  hal::host::Descriptor terminal_;
  hal::host::SlcanHost slcan_{};
  bool up_ = true;
};

std::string emergency_text(const CanHost::Emergency& emergency) {
  switch (emergency.code) {
    case can::kNoError:
      return "the error has ended";
    case can::kFramesLost:
      return "frames were lost on the bus";
    case can::kHostSilent:
      return "it missed the sender's heartbeat";
    case can::kDeviceSpecific:
      return fmt::format("alarm {}", emergency.alarm);
    default:
      return fmt::format("error {:04X}", emergency.code);
  }
}

}  // namespace

CanNodePort::CanNodePort(std::unique_ptr<CanWire> wire, std::uint8_t node)
    : wire_{std::move(wire)}, node_{node}, host_{wire_->port(), node} {
  attend();
}

CanNodePort::~CanNodePort() {
  static_cast<void>(host_.order(can::NetworkCommand::kResetCommunication));
  wire_->carry();
}

std::size_t CanNodePort::read(std::span<char> into) {
  attend();
  return host_.read(std::as_writable_bytes(into));
}

std::size_t CanNodePort::write(std::string_view bytes) {
  const std::size_t count = host_.write(std::as_bytes(std::span{bytes}));
  attend();
  return count;
}

std::size_t CanNodePort::act(std::string_view bytes) {
  constexpr std::size_t kInFrame = 8;
  const std::string_view some = bytes.substr(0, kInFrame);
  if (some.empty() || !host_.act(std::as_bytes(std::span{some}))) return 0;
  wire_->carry();
  return some.size();
}

std::string CanNodePort::take_news() {
  if (news_.empty()) return {};
  std::string first = std::move(news_.front());
  news_.pop_front();
  return first;
}

void CanNodePort::attend() {
  using std::chrono::microseconds;
  const auto now = Clock::now();
  // `host_` receives this time plus one heartbeat period, so that the first heartbeat is due
  // immediately.
  const auto passed = std::chrono::floor<microseconds>(now - begun_).count();
  wire_->carry();
  if (!started_) started_ = host_.order(can::NetworkCommand::kStart);
  host_.attend(hal::TickCount{CanHost::kHeartbeatUs}.plus(static_cast<std::uint32_t>(passed)));
  wire_->carry();
  hear_news(now);
  look_for_trouble();
}

void CanNodePort::hear_news(Clock::time_point now) {
  // Only time in which this host listened counts as silence of the node.
  silent_ += std::min<Clock::duration>(now - looked_, kMaxAway);
  looked_ = now;
  if (host_.frames() != frames_heard_) silent_ = {};
  frames_heard_ = host_.frames();
  for (; emergencies_ < host_.emergencies().size(); ++emergencies_) {
    const CanHost::Emergency& emergency = host_.emergencies()[emergencies_];
    news_.push_back(fmt::format("node {}: {}", node_, emergency_text(emergency)));
    // These codes end the session. The code of an alarm does not, because the node also reports the
    // alarm with its number as text.
    const bool ends = emergency.code == can::kFramesLost || emergency.code == can::kHostSilent;
    if (ends && trouble_.empty()) trouble_ = news_.back();
  }
}

void CanNodePort::look_for_trouble() {
  if (!trouble_.empty()) return;
  if (!wire_->up()) {
    trouble_ = fmt::format("{} {} is gone", wire_->kind(), wire_->address());
  } else if (silent_ > kNodeSilence) {
    trouble_ = fmt::format("node {} is silent on {}", node_, wire_->address());
  } else if (host_.sent().given_up > 0) {
    trouble_ = fmt::format("node {} accepts no data", node_);
  } else if (host_.received().lost > 0 || wire_->port().health().lost_frames > 0) {
    trouble_ = "frames from the controller were lost";
  }
}

std::unique_ptr<Port> open_can_port(const std::string& interface, std::uint8_t node) {
  return std::make_unique<CanNodePort>(
      std::make_unique<SocketCanWire>(interface, can::heard_by_host(node)), node);
}

std::unique_ptr<Port> open_slcan_port(const std::string& device, unsigned baud, std::uint8_t node) {
  return std::make_unique<CanNodePort>(std::make_unique<SlcanHostWire>(device, baud), node);
}

}  // namespace sim

#include "host-sim/serve/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "host-sim/job/setting_line.hpp"
#include "host-sim/machine/probe_surface.hpp"
#include "host-sim/serve/recorder.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim {
namespace {

constexpr std::uint64_t kTurnNs =
    VirtualController::kTicksPerTurn * VirtualController::kNanosecondsPerTick;

/// Link that plays the sender of a recorded conversation.
class RecordedLink final : public hal::ByteStream {
 public:
  explicit RecordedLink(const std::vector<Exchange>& exchanges) : exchanges_{exchanges} {}

  void tell(LinkListener* listener) { listener_ = listener; }

  /// Makes the bytes available that the recorded controller had read up to this time.
  void set_time(std::uint64_t now_ns) {
    now_full_ = now_stops_ = false;
    now_beside_.clear();
    now_said_ = 0;
    for (; next_ < exchanges_.size() && exchanges_[next_].time_ns <= now_ns; ++next_) {
      const Exchange& exchange = exchanges_[next_];
      if (exchange.kind == Exchange::Kind::kHeard) waiting_ += exchange.bytes;
      if (exchange.kind == Exchange::Kind::kBeside) now_beside_ += exchange.bytes;
      if (exchange.kind == Exchange::Kind::kSaid) now_said_ += exchange.bytes.size();
      if (exchange.kind == Exchange::Kind::kFull) now_full_ = true;
      if (exchange.kind == Exchange::Kind::kStop) now_stops_ = true;
    }
  }

  /// Returns whether an emergency stop over the bus reached the controller before this cycle.
  [[nodiscard]] bool stops() const { return now_stops_; }
  /// Returns realtime bytes that acted outside the stream before this cycle.
  [[nodiscard]] std::span<const std::byte> beside() const {
    return std::as_bytes(std::span{now_beside_});
  }

  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), waiting_.size() - heard_);
    const auto bytes = std::as_bytes(std::span{waiting_}).subspan(heard_, count);
    std::copy(bytes.begin(), bytes.end(), into.begin());
    heard_ += count;
    if (count != 0) listener_->on_read(bytes);
    return count;
  }

  /// Takes no more bytes than the recorded sender took in this cycle.
  std::size_t write(std::span<const std::byte> from) override {
    const std::size_t count = now_full_ ? std::min(from.size(), now_said_) : from.size();
    now_said_ -= std::min(count, now_said_);
    if (count != 0) listener_->on_write(from.first(count));
    if (count < from.size()) listener_->on_full();
    return count;
  }

 private:
  const std::vector<Exchange>& exchanges_;
  LinkListener* listener_ = nullptr;
  std::size_t next_ = 0;
  std::string waiting_;
  std::string now_beside_;
  std::size_t heard_ = 0;  ///< Number of bytes of waiting_ that the controller has read.
  /// Number of bytes that may still be written in this cycle; it limits writes only if now_full_ is
  /// true.
  std::size_t now_said_ = 0;
  bool now_full_ = false;
  bool now_stops_ = false;
};

/// Start of the line in the answer to `$I` that contains the version.
constexpr std::string_view kVersionLine = "[KERFLINE:";

/// Output of the controller without its version, with the exchange of each byte.
struct Speech {
  explicit Speech(const Conversation& conversation) {
    for (const Exchange& exchange : conversation.exchanges) {
      if (exchange.kind != Exchange::Kind::kSaid) continue;
      bytes += exchange.bytes;
      places.insert(places.end(), exchange.bytes.size(), &exchange);
    }
    drop_versions();
  }

  /// Removes the text between `[KERFLINE:` and the next `]`.
  void drop_versions() {
    std::size_t from = 0;
    while ((from = bytes.find(kVersionLine, from)) != std::string::npos) {
      from += kVersionLine.size();
      const std::size_t to = std::min(bytes.find(']', from), bytes.size());
      bytes.erase(from, to - from);
      const auto begin = places.begin();
      places.erase(begin + static_cast<std::ptrdiff_t>(from),
                   begin + static_cast<std::ptrdiff_t>(to));
    }
  }

  /// Returns the line that contains the byte at `place`, without its line end.
  [[nodiscard]] std::string line_around(std::size_t place) const {
    if (place >= bytes.size()) return {};
    const std::size_t before = place == 0 ? std::string::npos : bytes.rfind('\n', place - 1);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return bytes.substr(first, bytes.find_first_of("\r\n", place) - first);
  }

  std::string bytes;
  std::vector<const Exchange*> places;
};

std::string with_time(const Speech& speech, std::size_t place, bool with_times) {
  std::string line = speech.line_around(place);
  if (!with_times || place >= speech.bytes.size()) return line;
  return fmt::format("{} at {} ns", line, speech.places[place]->time_ns);
}

MachineModel machine_of(const ConversationSetting& setting) {
  MachineModel machine{.probe_plate_z_mm = setting.probe_plate_z_mm};
  if (const auto& probed = setting.probe_surface) {
    const auto read = surface::read_surface(probed->file, "the recorded surface", {});
    machine.probe_surface = std::make_shared<const ProbeSurface>(read.mesh, probed->tip_mm);
  }
  return machine;
}

}  // namespace

Conversation replay(const Conversation& recorded) {
  RecordedLink link{recorded.exchanges};
  hal::host::MemoryStore store;
  for (const auto& [number, record] : recorded.setting.records) {
    if (!store.save(number, record)) throw std::invalid_argument("a record is too long");
  }
  VirtualController controller{link, machine_of(recorded.setting), store};
  apply_settings(recorded.setting.settings, controller.machine());
  Conversation said{.setting = recorded.setting, .exchanges = {}, .end_ns = recorded.end_ns};
  Recorder recorder{controller,
                    [&said](const Exchange& exchange) { said.exchanges.push_back(exchange); }};
  link.tell(&recorder);
  for (std::uint64_t now_ns = 0; now_ns < recorded.end_ns; now_ns += kTurnNs) {
    link.set_time(now_ns);
    if (link.stops()) {
      recorder.on_stop();
      controller.machine().emergency_stop();
    }
    for (const std::byte byte : link.beside()) {
      recorder.on_beside(byte);
      controller.firmware().act_at_once(byte);
    }
    controller.turn();
  }
  recorder.finish();
  return said;
}

std::optional<Difference> first_difference(const Conversation& expected,
                                           const Conversation& said,
                                           bool with_times) {
  const Speech before{expected};
  const Speech now{said};
  const std::size_t common = std::min(before.bytes.size(), now.bytes.size());
  std::size_t place = 0;
  while (place < common && before.bytes[place] == now.bytes[place] &&
         (!with_times || before.places[place]->time_ns == now.places[place]->time_ns)) {
    ++place;
  }
  if (place == before.bytes.size() && place == now.bytes.size()) return {};
  const bool at_end = place >= before.places.size();
  const std::size_t last_line = expected.exchanges.empty() ? 0 : expected.exchanges.back().line;
  return Difference{.line = at_end ? last_line : before.places[place]->line,
                    .expected = with_time(before, place, with_times),
                    .said = with_time(now, place, with_times)};
}

}  // namespace sim

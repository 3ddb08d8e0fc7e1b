#include "host-sim/serve/live_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "firmware/protocol/identity.hpp"
#include "firmware/protocol/report_lines.hpp"
#include "host-sim/send/code_words.hpp"
#include "host-sim/serve/run_conditions.hpp"

namespace sim {
namespace {

using nlohmann::ordered_json;
using std::chrono::milliseconds;

constexpr milliseconds kPeriod{50};
// Interval at which unchanged news are repeated, as a sign that the server runs.
constexpr milliseconds kRepeat{1000};
constexpr std::size_t kPointsPerMessage = 2000;
// Greatest number of unread bytes with which a watcher still gets news.
constexpr std::size_t kTooSlow = std::size_t{1} << 18;
constexpr std::size_t kAxesShown = 3;

double rounded(double value) { return std::round(value * 1000.0) / 1000.0; }

ordered_json travel_of(const cnc::Settings& settings) {
  ordered_json travel;
  for (std::size_t axis = 0; axis < kAxesShown; ++axis) {
    travel.push_back(settings.get(cnc::setting::kTravel, axis));
  }
  return travel;
}

std::string_view name_of(ServedJob::State state) {
  switch (state) {
    case ServedJob::State::kNone:
      return "none";
    case ServedJob::State::kLoaded:
      return "loaded";
    case ServedJob::State::kRunning:
      return "running";
    case ServedJob::State::kStopped:
      return "stopped";
    case ServedJob::State::kDone:
      return "done";
  }
  return {};
}

ordered_json state_of(const ServedJob& job,
                      std::string_view sender_kind,
                      const cnc::Machine& machine) {
  const ServedProgram* const program = job.program().get();
  return {{"name", program != nullptr ? program->name : ""},
          {"id", program != nullptr ? program->id : ""},
          {"state", name_of(job.state())},
          {"done", job.done()},
          {"count", job.count()},
          {"line", job.file_line()},
          {"trouble", job.trouble()},
          {"waits", awaited_by_run(job, sender_kind, machine)},
          {"resume_waits", awaited_by_resume(job, sender_kind, machine)}};
}

}  // namespace

LiveView::LiveView(const VirtualController& controller, const ServedJob& job)
    : controller_{controller}, job_{job} {
  keep_scale();
}

void LiveView::keep_scale() {
  cnc::AxisArray<float> steps_per_mm{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    steps_per_mm[axis] = controller_.machine().settings().get(cnc::setting::kStepsPerMm, axis);
  }
  if (recorder_ && steps_per_mm == steps_per_mm_) return;
  // Restarts the path after a change of steps per mm, because the recorded path has the old scale.
  steps_per_mm_ = steps_per_mm;
  recorder_.emplace(steps_per_mm);
  watchers_.clear();
}

void LiveView::publish(const std::vector<std::shared_ptr<WebSocket>>& watchers,
                       std::string_view sender_kind,
                       Clock::time_point now) {
  next_ = now + kPeriod;
  keep_scale();
  std::erase_if(watchers_, [](const auto& entry) { return entry.second.socket.expired(); });
  if (watchers.empty()) return;
  const std::string state = state_text(sender_kind);
  const bool news = state != last_state_ || now >= repeat_at_;
  if (news) repeat_at_ = now + kRepeat;
  last_state_ = state;
  for (const auto& socket : watchers) {
    const auto [place, is_new] = watchers_.try_emplace(socket.get());
    Watcher& watcher = place->second;
    watcher.socket = socket;
    const bool grown = watcher.points_sent != recorder_->settled().size();
    if (news || is_new || grown) tell(watcher, *socket, state);
  }
}

void LiveView::tell(Watcher& watcher, WebSocket& socket, const std::string& state) const {
  if (socket.unsent() > kTooSlow) return;
  const double seconds =
      static_cast<double>(controller_.now_ticks()) / cnc::motion::kTicksPerSecond;
  const std::string message =
      fmt::format(R"({{"t":{:.3f},{},"path":{}}})", seconds, state, path_text(watcher));
  socket.write(message);
}

/// Returns the members of the JSON object of the state, without the braces around them.
std::string LiveView::state_text(std::string_view sender_kind) const {
  const cnc::Machine& machine = controller_.machine();
  const cnc::MachineStatus status = machine.status();
  const cnc::OverridePercent& percent = machine.overrides();
  const cnc::Position position = machine.motion().tool_place();
  ordered_json mpos;
  ordered_json wco;
  ordered_json motors;
  for (std::size_t axis = 0; axis < kAxesShown; ++axis) {
    mpos.push_back(rounded(position[axis].mm()));
    const auto name = static_cast<cnc::Axis>(axis);
    wco.push_back(rounded(machine.interpreter().work_offset(name).mm()));
    motors.push_back(rounded(controller_.port().position[axis] / double{steps_per_mm_[axis]}));
  }
  const ordered_json state{
      {"state", cnc::name_of(status.state)},
      {"substate", status.substate},
      {"alarm", static_cast<int>(machine.alarm())},
      {"mpos", mpos},
      {"wco", wco},
      {"motors", motors},
      {"feed", std::round(machine.motion().speed_mm_min())},
      {"power", rounded(controller_.port().power / double{cnc::motion::kFullOutput})},
      {"spindle", std::round(machine.spindle_now())},
      {"overrides", {percent.feed, percent.rapid, percent.power}},
      {"line", machine.motion().line_in_execution()},
      {"homed", machine.homed()},
      {"sender", sender_kind},
      {"travel", travel_of(machine.settings())},
      {"most_spindle", machine.settings().get(cnc::setting::kMaxSpindleSpeed)},
      {"version", cnc::identity::version()},
      {"alarm_text", alarm_words(static_cast<std::uint32_t>(machine.alarm()))},
      {"job", state_of(job_, sender_kind, machine)}};
  // File names and quoted words of programs may contain any byte.
  const std::string text = state.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return text.substr(1, text.size() - 2);
}

std::string LiveView::path_text(Watcher& watcher) const {
  ordered_json points = ordered_json::array();
  const std::size_t count = recorder_->settled().size();
  // If the path has fewer points than were sent, the recorder has thinned it. All points of the
  // path are then sent again.
  const std::size_t from = watcher.points_sent <= count ? watcher.points_sent : 0;
  const std::size_t to = std::min(count, from + kPointsPerMessage);
  for (std::size_t index = from; index < to; ++index) {
    const PathVertex& vertex = recorder_->settled()[index];
    points.push_back(rounded(vertex.x_mm));
    points.push_back(rounded(vertex.y_mm));
    points.push_back(std::round(vertex.speed_mm_s * 10.0) / 10.0);
    points.push_back(static_cast<int>(vertex.move));
  }
  watcher.points_sent = to;
  return ordered_json{{"from", from}, {"points", points}}.dump();
}

Path LiveView::path_so_far() const {
  PathRecorder copy = *recorder_;
  copy.on_end(controller_.now_ticks() * VirtualController::kNanosecondsPerTick);
  return copy.path();
}

}  // namespace sim

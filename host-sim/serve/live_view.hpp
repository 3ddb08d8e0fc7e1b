#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/plot/path_recorder.hpp"
#include "host-sim/serve/served_job.hpp"
#include "host-sim/serve/web_socket.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Sends watchers the machine's state about twenty times a second, and the path as it grows, as
/// JSON:
///
///     {"t":1.25,"state":"Run","substate":0,"alarm":0,"mpos":[…],"wco":[…],
///      "motors":[…],"feed":1200,"power":0.5,"spindle":500,"overrides":[100,100,100],
///      "line":12,"homed":3,"sender":"ws","travel":[300,200,50],"max_spindle":1000,
///      "version":"0.2.0+9fa115e","alarm_text":"",
///      "job":{"name":"part.nc","id":"3f…","state":"running","done":12,"count":83,"line":15,
///             "trouble":"","waits":"the end of the running job","resume_waits":"…"},
///      "path":{"from":17,"points":[x,y,speed,move, …]}}
///
/// Lengths are in mm, speeds of the path in mm/s, `feed` in mm/min. `power` is the output, 0…1.
/// `move` is 0 for travel, 1 for feed, and 2 for feed with beam or spindle on. `motors` are
/// positions since power-up, and the path has the same coordinates: a change of machine coordinates
/// by homing does not move the path that was drawn. `alarm_text` has the description and the remedy
/// of the alarm. The `state` of a job is `none`, `loaded`, `running`, `stopped` or `done`. `line`
/// is the line of the job's file that comes next. `trouble` is the reason for the job's stop, with
/// the remedy. `waits` is awaited_by_run(), and `resume_waits` is awaited_by_resume().
class LiveView final : public TraceSink {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param controller must outlive the view
  /// @param job must outlive the view
  LiveView(const VirtualController& controller, const ServedJob& job);

  void on_row(const TraceRow& row) override { recorder_->on_row(row); }

  [[nodiscard]] bool due(Clock::time_point now) const { return now >= next_; }
  /// Sends the news to the watchers. Call it when due() returns true.
  void publish(const std::vector<std::shared_ptr<WebSocket>>& watchers,
               std::string_view sender_kind,
               Clock::time_point now);
  /// Returns the path that was driven so far.
  [[nodiscard]] Path path_so_far() const;

 private:
  struct Watcher {
    std::weak_ptr<WebSocket> socket;
    std::size_t points_sent = 0;
  };

  void keep_scale();
  void tell(Watcher& watcher, WebSocket& socket, const std::string& state) const;
  [[nodiscard]] std::string state_text(std::string_view sender_kind) const;
  [[nodiscard]] std::string path_text(Watcher& watcher) const;

  const VirtualController& controller_;
  const ServedJob& job_;
  cnc::AxisArray<float> steps_per_mm_{};
  /// Recorder of the path. It always has a value, and is optional only so that a change of scale
  /// can replace it.
  std::optional<PathRecorder> recorder_;
  std::map<const WebSocket*, Watcher> watchers_;
  std::string last_state_;
  Clock::time_point next_;
  Clock::time_point repeat_at_;
};

}  // namespace sim

#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/plot/path_recorder.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/web_pipe.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// What those who watch see: the machine's state some twenty times a second and
/// the path as it grows, as JSON.
///
///     {"t":1.25,"state":"Run","substate":0,"alarm":0,"mpos":[…],"wco":[…],
///      "motors":[…],"feed":1200,"power":0.5,"spindle":500,"overrides":[100,100,100],
///      "line":12,"homed":3,"sender":"ws","travel":[300,200,50],"most_spindle":1000,
///      "version":"0.2.0+9fa115e",
///      "path":{"from":17,"points":[x,y,speed,move, …]}}
///
/// Lengths in mm, speeds of the path in mm/s, `feed` in mm/min, `power` the
/// output 0…1, `move` 0 travel, 1 feed, 2 beam or spindle on. `motors` are
/// places since power-up, in whose coordinates the path is: a change of machine
/// coordinates by homing does not move what was drawn.
///
/// An outline is in machine coordinates, up to the refused line if there is one:
///
///     {"points":[x,y,move, …],"refused":{"line":3,"column":1,"number":20,"reason":"…"}}
class LiveView final : public TraceSink, public PageService {
 public:
  using Clock = std::chrono::steady_clock;

  /// The controller must outlive it.
  explicit LiveView(const VirtualController& controller);

  void on_row(const TraceRow& row) override { recorder_->on_row(row); }

  // The loop's thread.

  [[nodiscard]] bool due(Clock::time_point now) const { return now >= next_; }
  /// Tells the watchers. To be called when due.
  void publish(const std::vector<std::shared_ptr<WebPipe>>& watchers,
               std::string_view sender_kind,
               Clock::time_point now);
  /// Answers what other threads ask for. To be called often.
  void answer_questions();

  // Any thread; they wait for the loop.

  [[nodiscard]] Document picture() override;
  [[nodiscard]] std::optional<Document> outline(std::string_view program) override;

 private:
  struct Watcher {
    std::weak_ptr<WebPipe> pipe;
    std::size_t points_sent = 0;
  };

  /// What `question` answers in the loop's thread; nothing when that takes too long.
  template <typename Question>
  [[nodiscard]] auto ask(Question question) -> std::optional<std::invoke_result_t<Question>>;

  [[nodiscard]] Path path_so_far() const;
  void keep_scale();
  void tell(Watcher& watcher, WebPipe& pipe, const std::string& state) const;
  [[nodiscard]] std::string state_text(std::string_view sender_kind) const;
  [[nodiscard]] std::string path_text(Watcher& watcher) const;

  const VirtualController& controller_;
  cnc::AxisArray<float> steps_per_mm_{};
  std::optional<PathRecorder> recorder_;  ///< Always there.
  std::map<const WebPipe*, Watcher> watchers_;
  std::string last_state_;
  Clock::time_point next_;
  Clock::time_point repeat_at_;
  std::mutex mutex_;  ///< Of what follows; the loop's alone is what comes before.
  std::vector<std::function<void()>> questions_;
};

}  // namespace sim

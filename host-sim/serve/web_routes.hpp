#pragma once

#include <optional>
#include <string>

#include "host-sim/serve/live_view.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/served_job.hpp"

namespace sim {

/// What the web server answers over HTTP:
///
/// | | |
/// |---|---|
/// | GET | the files of the page; `/picture.svg`, the motion so far; `/job`, the job as below |
/// | POST `/outline` | where a program would go if it ran now |
/// | POST `/job?name=…` | the same, and keeps the program as the job |
/// | POST `/job/run` | runs it; the body is a list of the faults that the operator has accepted |
/// | POST `/job/resume`, `/job/stop` | goes on where it was interrupted; ends it at standstill |
///
/// An outline is in machine coordinates, up to the refused line if there is one:
///
///     {"name":"part.nc","points":[x,y,move, …],"faults":["line 5: …"],
///      "refused":{"line":3,"column":1,"number":20,"reason":"…"}}
///
/// A program with faults, or beyond the travel, is not run unless each of them was accepted: 409
/// and `{"faults":[…]}`. What else a job waits for is told as 409 and `{"waits":"…"}`.
class WebRoutes final : public PageService {
 public:
  /// All of them must outlive it.
  WebRoutes(const VirtualController& controller,
            const LiveView& view,
            const Reception& reception,
            ServedJob& job)
      : controller_{controller}, view_{view}, reception_{reception}, job_{job} {}

  [[nodiscard]] std::optional<WebReply> refusal(const HttpRequest& request) const override;
  [[nodiscard]] Answer answer(HttpRequest request) override;

 private:
  [[nodiscard]] Answer get(const std::string& path) const;
  [[nodiscard]] WebWork outline(std::string name, std::shared_ptr<const std::string> program) const;
  [[nodiscard]] Answer load(HttpRequest request);
  [[nodiscard]] WebReply run(const std::string& accepted);
  [[nodiscard]] WebReply resume();
  [[nodiscard]] WebReply stop();
  [[nodiscard]] std::string awaited() const;

  const VirtualController& controller_;
  const LiveView& view_;
  const Reception& reception_;
  ServedJob& job_;
};

}  // namespace sim

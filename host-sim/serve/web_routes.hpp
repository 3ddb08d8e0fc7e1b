#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/serve/live_view.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/served_job.hpp"

namespace sim {

/// The resources of the web server over HTTP:
///
/// | | |
/// |---|---|
/// | GET | the files of the page; `/picture.svg`, the motion so far |
/// | GET `/words` | descriptions and remedies of alarms and errors |
/// | GET `/job` | the job as below |
/// | POST `/outline` | the outline of a program: the path that it would take if it ran now |
/// | POST `/job?name=…` | the outline of a program, which also becomes the job |
/// | POST `/job/run` | runs the job, `{"id":"…","page":"…","accepted":["line 4: …"]}` |
/// | POST `/job/resume` | resumes the job where it was interrupted, `{"id":…,"page":…}` |
/// | POST `/job/stop` | ends the job, `{"id":…,"page":…}` |
/// | POST `/sheet` | places the parts of a sheet that is being edited: see placed_sheet() |
/// | POST `/hold` | holds the feed, which is safe, so any page that watches may request it |
///
/// An outline is in machine coordinates, and ends before the refused line if there is one:
///
///     {"name":"part.nc","id":"…","points":[x,y,move, …],
///      "faults":["line 5: …"],"notes":["line 9: …"],
///      "refused":{"line":3,"column":1,"number":20,"reason":"…"}}
///
/// Only the page that controls the machine can order a job. `page` is the key that the page
/// received in the first line of its connection, and `id` names the program that it shows. A
/// program with faults, or one that leaves the travel, is not run unless each fault was accepted:
/// the answer is 409 and `{"faults":[…],"fault_count":1}`. If a job has to wait for any other
/// reason, the answer is 409 and `{"waits":"…"}`, with `"again":true` while its program is being
/// judged.
class WebRoutes final : public PageService {
 public:
  /// All arguments must outlive this object.
  WebRoutes(const VirtualController& controller,
            const LiveView& view,
            Reception& reception,
            ServedJob& job)
      : controller_{controller}, view_{view}, reception_{reception}, job_{job} {}

  [[nodiscard]] std::optional<WebReply> refusal(const HttpRequest& request) const override;
  [[nodiscard]] Answer answer(HttpRequest request) override;

 private:
  [[nodiscard]] Answer get(const std::string& path) const;
  [[nodiscard]] Answer load(HttpRequest request) const;
  [[nodiscard]] WebReply order(const std::string& path, const std::string& body);
  [[nodiscard]] WebReply run(const std::vector<std::string>& accepted);
  [[nodiscard]] const Judgement* judgement();

  const VirtualController& controller_;
  const LiveView& view_;
  Reception& reception_;
  ServedJob& job_;
  /// Task that makes a judgement of the program in another thread.
  BackgroundTask<Judged> judging_{};
  std::string judging_key_;  ///< Key of the judgement that this task makes.
};

}  // namespace sim

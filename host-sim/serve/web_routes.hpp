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
/// | GET `/words` | alarms and errors in words |
/// | GET `/job` | the job as below |
/// | POST `/outline` | where a program would go if it ran now |
/// | POST `/job?name=…` | the same, and keeps the program as the job |
/// | POST `/job/run` | runs it, `{"id":"…","page":"…","accepted":["line 4: …"]}` |
/// | POST `/job/resume` | resumes it where it was interrupted, `{"id":…,"page":…}` |
/// | POST `/job/stop` | ends it, `{"id":…,"page":…}` |
/// | POST `/sheet` | a sheet that is being edited: see placed_sheet() |
/// | POST `/hold` | a feed hold: it is safe, so that any page that watches may ask for it |
///
/// An outline is in machine coordinates, up to the refused line if there is one:
///
///     {"name":"part.nc","id":"…","points":[x,y,move, …],
///      "faults":["line 5: …"],"notes":["line 9: …"],
///      "refused":{"line":3,"column":1,"number":20,"reason":"…"}}
///
/// A job is ordered by the page that controls the machine, whose key `page` came in its first line,
/// for the program `id` that it shows. A program with faults, or beyond the travel, is not run
/// unless each of them was accepted: 409 and `{"faults":[…],"fault_count":1}`. Any other reason for
/// which a job waits is 409 and `{"waits":"…"}`, with `"again":true` while its program is being
/// judged.
class WebRoutes final : public PageService {
 public:
  /// All of them must outlive it.
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
  BackgroundTask<Judged> judging_{};  ///< A judgement that is being made,
  std::string judging_key_;           ///< and its key.
};

}  // namespace sim

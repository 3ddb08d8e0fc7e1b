#include "host-sim/serve/web_routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "firmware/protocol/report_lines.hpp"
#include "host-sim/page/page_file.hpp"
#include "host-sim/plot/outline.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/job_check.hpp"

namespace sim {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLongestName = 200;
constexpr const char* kJsonType = "application/json";

constexpr std::array<std::string_view, 2> kProgramPaths{"/outline", "/job"};
constexpr std::array<std::string_view, 3> kOrderPaths{"/job/run", "/job/resume", "/job/stop"};

template <typename Paths>
bool is_one_of(const Paths& paths, std::string_view path) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

const PageFile* page_file(std::string_view path) {
  const auto files = page_files();
  const auto found = std::find_if(
      files.begin(), files.end(), [path](const PageFile& file) { return file.path == path; });
  return found == files.end() ? nullptr : &*found;
}

bool is_document(std::string_view path) {
  return page_file(path) != nullptr || path == "/picture.svg" || path == "/job";
}

const char* type_of_file(std::string_view path) {
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "text/html; charset=utf-8";
}

/// A word at fault may be any byte.
WebReply json_reply(const ordered_json& json, int status = http_status::kFine) {
  return {.status = status,
          .type = kJsonType,
          .content = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace)};
}

double in_micrometres(double length_mm) { return std::round(length_mm * 1000.0) / 1000.0; }

ordered_json outline_json(const std::string& name,
                          const ProgramOutline& outline,
                          const std::vector<JobFault>& faults) {
  ordered_json points = ordered_json::array();
  for (const PathVertex& vertex : outline.vertices) {
    points.push_back(in_micrometres(vertex.x_mm));
    points.push_back(in_micrometres(vertex.y_mm));
    points.push_back(static_cast<int>(vertex.move));
  }
  ordered_json json{{"points", std::move(points)}, {"faults", ordered_json::array()}};
  if (!name.empty()) json["name"] = name;
  for (const JobFault& fault : faults) json["faults"].push_back(fault.text());
  if (const auto& refused = outline.refused) {
    json["refused"] = {{"line", refused->line},
                       {"column", refused->column},
                       {"number", refused->number},
                       {"reason", refused->reason}};
  }
  return json;
}

/// The texts of a list; none of what is no list of texts.
std::vector<std::string> texts_of(const std::string& body) {
  const ordered_json list = ordered_json::parse(body, nullptr, false);
  std::vector<std::string> texts;
  if (!list.is_array()) return texts;
  for (const ordered_json& one : list) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
}

/// As a page gets it back: a fault may quote any byte.
std::string as_json_has_it(const std::string& text) {
  return ordered_json::parse(
      ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

WebReply waits(const std::string& reason) {
  return json_reply({{"waits", reason}}, http_status::kConflict);
}

}  // namespace

std::optional<WebReply> WebRoutes::refusal(const HttpRequest& request) const {
  const std::string_view path = request.path;
  const bool program = is_one_of(kProgramPaths, path);
  const bool order = is_one_of(kOrderPaths, path);
  if (!is_document(path) && !program && !order) {
    return web_refusal(http_status::kNotFound, "There is nothing of that name here.");
  }
  if (request.method == "GET" || request.method == "HEAD") {
    if (is_document(path)) return {};
    return web_refusal(http_status::kWrongMethod, "A program is sent here with POST.");
  }
  if (request.method != "POST" || (!program && !order)) {
    return web_refusal(http_status::kWrongMethod, "This is only read, with GET.");
  }
  if (!request.length) {
    return web_refusal(http_status::kLengthRequired, "The length of the program is not given.");
  }
  if (path == "/job" && job_.running()) {
    return web_refusal(http_status::kConflict,
                       "A job runs. Another program is opened when it has ended.");
  }
  return {};
}

PageService::Answer WebRoutes::answer(HttpRequest request) {
  if (request.method != "POST") return get(request.path);
  if (request.path == "/job") return load(std::move(request));
  if (request.path == "/job/run") return run(request.body);
  if (request.path == "/job/resume") return resume();
  if (request.path == "/job/stop") return stop();
  return outline({}, std::make_shared<const std::string>(std::move(request.body)));
}

PageService::Answer WebRoutes::get(const std::string& path) const {
  if (const PageFile* file = page_file(path)) {
    return WebReply{.type = type_of_file(path), .content = std::string{file->content}};
  }
  if (path == "/picture.svg") {
    return WebWork{[so_far = view_.path_so_far()] {
      return WebReply{.type = "image/svg+xml",
                      .content = draw_svg(so_far, {.title = "Motion so far"})};
    }};
  }
  if (!job_.loaded()) {
    return web_refusal(http_status::kNotFound, "No program has been opened.");
  }
  return outline(job_.name(), job_.program());
}

/// With copies of all that the loop may change meanwhile.
WebWork WebRoutes::outline(std::string name, std::shared_ptr<const std::string> program) const {
  const cnc::Machine& machine = controller_.machine();
  return [name = std::move(name),
          program = std::move(program),
          reader = machine.interpreter(),
          settings = machine.settings(),
          homed = machine.homed()] {
    return json_reply(outline_json(
        name, program_outline_of(*program, reader), job_faults(*program, reader, settings, homed)));
  };
}

PageService::Answer WebRoutes::load(HttpRequest request) {
  // It may have begun while the program came.
  if (job_.running()) return waits("the end of the job that runs");
  job_.load(request.query["name"].substr(0, kLongestName), std::move(request.body));
  return outline(job_.name(), job_.program());
}

/// What a job waits for before it may begin; empty for nothing.
std::string WebRoutes::awaited() const {
  if (!job_.loaded()) return "a program: open one";
  if (job_.running()) return "the end of the job that runs";
  if (!reception_.operated_by_page()) return "a page that has control: take control";
  const cnc::MachineState state = controller_.machine().state();
  if (state == cnc::MachineState::kAlarm) return "the end of the alarm: home or unlock";
  if (state == cnc::MachineState::kIdle) return {};
  return fmt::format("an idle machine; its state is {}", cnc::name_of(state));
}

WebReply WebRoutes::run(const std::string& accepted) {
  if (const std::string reason = awaited(); !reason.empty()) return waits(reason);
  const cnc::Machine& machine = controller_.machine();
  const std::vector<std::string> known = texts_of(accepted);
  ordered_json faults = ordered_json::array();
  bool all_known = true;
  for (const JobFault& fault :
       job_faults(*job_.program(), machine.interpreter(), machine.settings(), machine.homed())) {
    const std::string text = as_json_has_it(fault.text());
    all_known = all_known && std::find(known.begin(), known.end(), text) != known.end();
    faults.push_back(text);
  }
  if (!all_known) return json_reply({{"faults", faults}}, http_status::kConflict);
  job_.run(ServedJob::Clock::now());
  return json_reply({{"runs", job_.name()}});
}

/// A machine in alarm is unlocked where its place is known.
WebReply WebRoutes::resume() {
  const bool in_alarm = controller_.machine().state() == cnc::MachineState::kAlarm;
  if (const std::string reason = awaited(); !reason.empty() && !in_alarm) return waits(reason);
  if (!job_.loaded() || job_.running() || !reception_.operated_by_page()) return waits(awaited());
  job_.resume(ServedJob::Clock::now());
  return json_reply({{"runs", job_.name()}});
}

WebReply WebRoutes::stop() {
  if (!job_.running()) return waits("a job that runs");
  job_.stop();
  return json_reply({{"stops", job_.name()}});
}

}  // namespace sim

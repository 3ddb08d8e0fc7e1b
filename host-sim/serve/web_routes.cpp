#include "host-sim/serve/web_routes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host-sim/job/program_digest.hpp"
#include "host-sim/page/page_file.hpp"
#include "host-sim/plot/outline.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/send/code_words.hpp"
#include "host-sim/serve/background_priority.hpp"
#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/run_conditions.hpp"
#include "host-sim/serve/sheet_view.hpp"

namespace sim {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLongestName = 200;
constexpr const char* kJsonType = "application/json";

constexpr std::array<std::string_view, 2> kProgramPaths{"/outline", "/job"};
constexpr std::string_view kSheetPath = "/sheet";
constexpr std::array<std::string_view, 4> kOrderPaths{
    "/job/run", "/job/resume", "/job/stop", "/hold"};

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
  return page_file(path) != nullptr || path == "/picture.svg" || path == "/job" || path == "/words";
}

const char* type_of_file(std::string_view path) {
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "text/html; charset=utf-8";
}

/// Returns a reply with JSON. Invalid UTF-8 is replaced, because a quoted word of a program may
/// contain any byte.
WebReply json_reply(const ordered_json& json, int status = http_status::kFine) {
  return {.status = status,
          .type = kJsonType,
          .content = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace)};
}

double in_micrometres(double length_mm) { return std::round(length_mm * 1000.0) / 1000.0; }

ordered_json outline_json(const ProgramOutline& outline) {
  ordered_json points = ordered_json::array();
  for (const PathVertex& vertex : outline.vertices) {
    points.push_back(in_micrometres(vertex.x_mm));
    points.push_back(in_micrometres(vertex.y_mm));
    points.push_back(static_cast<int>(vertex.move));
  }
  ordered_json json{{"points", std::move(points)}};
  if (const auto& refused = outline.refused) {
    json["refused"] = {{"line", refused->line},
                       {"column", refused->column},
                       {"number", refused->number},
                       {"reason", refused->reason}};
  }
  return json;
}

WebReply shown(const ServedProgram& program,
               const Standpoint& standpoint,
               const Judgement& judgement) {
  ordered_json json = outline_json(program_outline_of(program.text, standpoint.reader));
  json["faults"] = program.barriers;
  for (std::string& text : judgement.texts()) json["faults"].push_back(std::move(text));
  // The page shows only the first note. So the note that the program is stale comes first, before
  // notes about parts of the file that were left out.
  std::vector<std::string> notes =
      stale_inputs(program.text, {}, DigestFiles::kBelowFolder, &standpoint.settings);
  notes.insert(notes.end(), program.notes.begin(), program.notes.end());
  if (!notes.empty()) json["notes"] = std::move(notes);
  if (!program.name.empty()) {
    json["name"] = program.name;
    json["id"] = program.id;
    json["fault_count"] = program.barriers.size() + judgement.faults.size() + judgement.more;
  }
  return json_reply(json);
}

ordered_json words_json() {
  ordered_json json{{"alarms", ordered_json::object()}, {"errors", ordered_json::object()}};
  for (const CodeRemedy& one : alarm_remedies()) {
    json["alarms"][std::to_string(one.number)] = alarm_words(one.number);
  }
  for (const CodeRemedy& one : error_remedies()) {
    json["errors"][std::to_string(one.number)] = error_words(one.number);
  }
  return json;
}

/// Order of a page to run, resume or stop a job. All members are empty if the request is no order.
struct Order {
  std::string id;
  std::string page;
  std::vector<std::string> accepted;
};

std::string text_in(const ordered_json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

Order order_in(const std::string& body) {
  const ordered_json json = ordered_json::parse(body, nullptr, false);
  if (!json.is_object()) return {};
  Order order{.id = text_in(json, "id"), .page = text_in(json, "page"), .accepted = {}};
  const auto list = json.find("accepted");
  if (list == json.end() || !list->is_array()) return order;
  for (const ordered_json& one : *list) {
    if (one.is_string()) order.accepted.push_back(one.get<std::string>());
  }
  return order;
}

/// Returns a text as it arrives from a page that received it as JSON. A fault may quote any byte,
/// and JSON replaces invalid UTF-8.
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
  const bool order = is_one_of(kOrderPaths, path) || path == kSheetPath;
  if (!is_document(path) && !program && !order) {
    return web_refusal(http_status::kNotFound, "This server has no such address.");
  }
  if (request.method == "GET" || request.method == "HEAD") {
    if (is_document(path)) return {};
    return web_refusal(http_status::kWrongMethod, "This address accepts only POST.");
  }
  if (request.method != "POST" || (!program && !order)) {
    return web_refusal(http_status::kWrongMethod, "This address accepts only GET.");
  }
  if (!request.length) {
    return web_refusal(http_status::kLengthRequired, "The request does not give its length.");
  }
  if (path == "/job" && job_.running()) {
    return web_refusal(http_status::kConflict,
                       "A job runs. Open the program when the job has ended.");
  }
  return {};
}

PageService::Answer WebRoutes::answer(HttpRequest request) {
  job_.collect();
  if (request.method != "POST") return get(request.path);
  if (request.path == "/hold") {
    reception_.hold();
    return json_reply({{"holds", true}});
  }
  if (is_one_of(kProgramPaths, request.path)) return load(std::move(request));
  if (request.path == kSheetPath) {
    return WebWork{[body = std::make_shared<std::string>(std::move(request.body))] {
      work_in_background();
      return placed_sheet(*body);
    }};
  }
  return order(request.path, request.body);
}

PageService::Answer WebRoutes::get(const std::string& path) const {
  if (const PageFile* file = page_file(path)) {
    return WebReply{.type = type_of_file(path), .content = std::string{file->content}};
  }
  if (path == "/words") return json_reply(words_json());
  if (path == "/picture.svg") {
    return WebWork{[so_far = view_.path_so_far()] {
      work_in_background();
      return WebReply{.type = "image/svg+xml",
                      .content = draw_svg(so_far, {.title = "Motion so far"})};
    }};
  }
  if (!job_.loaded()) {
    return web_refusal(http_status::kNotFound, "No program has been opened.");
  }
  return WebWork{[program = job_.program(), standpoint = standpoint_of(controller_.machine())] {
    work_in_background();
    return shown(*program, standpoint, judge_program(program->name, program->text, standpoint));
  }};
}

/// Returns the work that prepares a program in another thread. The work uses copies of all data
/// that the loop may change meanwhile.
PageService::Answer WebRoutes::load(HttpRequest request) const {
  // A job may have begun while the program was received.
  const bool keeps = request.path == "/job";
  if (keeps && job_.running()) return waits("the end of the running job");
  std::string name = keeps ? request.query["name"].substr(0, kLongestName) : std::string{};
  return WebWork{[name = std::move(name),
                  file = std::make_shared<std::string>(std::move(request.body)),
                  inbox = keeps ? job_.inbox() : nullptr,
                  standpoint = standpoint_of(controller_.machine())] {
    work_in_background();
    const auto program = prepare_served(name, std::move(*file), standpoint.block_delete());
    Judged judged{.key = judgement_key(*program, standpoint),
                  .judgement = judge_program(name, program->text, standpoint)};
    WebReply reply = shown(*program, standpoint, judged.judgement);
    if (inbox) inbox->put({.program = program, .judged = std::move(judged)});
    return reply;
  }};
}

WebReply WebRoutes::order(const std::string& path, const std::string& body) {
  const Order order = order_in(body);
  const cnc::Machine& machine = controller_.machine();
  const std::string_view kind = reception_.sender_kind();
  const std::string reason = path == "/job/run"      ? awaited_by_run(job_, kind, machine)
                             : path == "/job/resume" ? awaited_by_resume(job_, kind, machine)
                             : job_.running()        ? std::string{}
                                                     : "a running job";
  if (!reason.empty()) return waits(reason);
  if (!reception_.is_operator(order.page)) return waits("control, which this page does not have");
  if (order.id != job_.program()->id) {
    return waits("a check of the program: another one was opened, " + job_.program()->name);
  }
  if (path == "/job/run") return run(order.accepted);
  if (path == "/job/resume") {
    job_.resume(ServedJob::Clock::now());
    return json_reply({{"runs", job_.program()->name}});
  }
  job_.stop();
  return json_reply({{"stops", job_.program()->name}});
}

/// Returns the judgement of the job for the present state of the machine. If there is none yet,
/// starts to make it and returns null.
const Judgement* WebRoutes::judgement() {
  const Standpoint standpoint = standpoint_of(controller_.machine());
  const std::string key = judgement_key(*job_.program(), standpoint);
  if (auto judged = judging_.take()) job_.keep(std::move(*judged));
  if (const Judgement* const known = job_.judgement(key)) return known;
  if (judging_.running() && judging_key_ == key) return nullptr;
  judging_key_ = key;
  judging_.start([program = job_.program(), standpoint, key](const std::atomic<bool>& cancelled) {
    return Judged{.key = key,
                  .judgement = judge_program(program->name, program->text, standpoint, &cancelled)};
  });
  return nullptr;
}

WebReply WebRoutes::run(const std::vector<std::string>& accepted) {
  const Judgement* const known = judgement();
  if (known == nullptr) {
    return json_reply({{"waits", "the check of the program"}, {"again", true}},
                      http_status::kConflict);
  }
  ordered_json faults = ordered_json::array();
  bool all_accepted = true;
  for (const std::string& fault : known->texts()) {
    const std::string text = as_json_has_it(fault);
    all_accepted = all_accepted && std::ranges::find(accepted, text) != accepted.end();
    faults.push_back(text);
  }
  if (!all_accepted) {
    return json_reply({{"faults", faults}, {"fault_count", known->faults.size() + known->more}},
                      http_status::kConflict);
  }
  job_.run(ServedJob::Clock::now());
  return json_reply({{"runs", job_.program()->name}});
}

}  // namespace sim

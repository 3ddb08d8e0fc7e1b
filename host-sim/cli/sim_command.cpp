#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/stock_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/report_text.hpp"
#include "host-sim/report/terminal.hpp"

namespace sim {
namespace {

constexpr const char* kPlaceholder = "{}";

struct SimOptions {
  JobOptions job;
  JobOutputs outputs;
  StockOptions stock;
  std::string report;
};

void require_placeholder(const std::string& name, const std::string& option) {
  if (name.empty() || name.find(kPlaceholder) != std::string::npos) return;
  throw std::invalid_argument(fmt::format(
      "{} {}: with several programs the name requires a {{}}, which stands for the name of each",
      option,
      name));
}

std::string with_job_name(const std::string& name, const std::string& file) {
  const std::size_t place = name.find(kPlaceholder);
  if (place == std::string::npos) return name;
  const std::string job = file == "-" ? "stdin" : std::filesystem::path{file}.stem().string();
  return name.substr(0, place) + job + name.substr(place + 2);
}

StockOptions stock_for(const StockOptions& asked, const std::string& file) {
  StockOptions options = asked;
  for (std::string StockOptions::*name :
       {&StockOptions::png, &StockOptions::stl, &StockOptions::ply, &StockOptions::map}) {
    options.*name = with_job_name(asked.*name, file);
  }
  return options;
}

JobOutputs outputs_for(const SimOptions& options, const std::string& file) {
  const JobOutputs& asked = options.outputs;
  return {.trace = with_job_name(asked.trace, file),
          .vcd = with_job_name(asked.vcd, file),
          .svg = with_job_name(asked.svg, file),
          .png = with_job_name(asked.png, file),
          .knots = with_job_name(asked.knots, file),
          .answers = with_job_name(asked.answers, file),
          .kerf_width_mm = asked.kerf_width_mm,
          .stock = stock_wish_of(stock_for(options.stock, file))};
}

/// Returns all files of the call. Placeholders in their names are replaced.
std::vector<NamedFile> files_of(const SimOptions& options) {
  std::vector<NamedFile> files;
  for (const std::string& file : options.job.files) {
    files.push_back({"FILE", file, FileRole::kInput});
  }
  if (!options.job.machine.empty()) {
    files.push_back({"--machine", options.job.machine, FileRole::kInput});
  }
  if (!options.job.settings_file.empty()) {
    files.push_back({"--settings", options.job.settings_file, FileRole::kInput});
  }
  if (!options.job.probe.surface.empty()) {
    files.push_back({"--probe-surface", options.job.probe.surface, FileRole::kInput});
  }
  if (!options.stock.target.empty()) {
    files.push_back({"--stock-target", options.stock.target, FileRole::kInput});
  }
  if (!options.stock.surface.empty()) {
    files.push_back({"--stock-surface", options.stock.surface, FileRole::kInput});
  }
  for (const std::string& file : options.job.files) {
    const JobOutputs outputs = outputs_for(options, file);
    for (const auto& [option, name] : std::initializer_list<std::pair<const char*, std::string>>{
             {"--trace", outputs.trace},
             {"--vcd", outputs.vcd},
             {"--svg", outputs.svg},
             {"--png", outputs.png},
             {"--knots", outputs.knots},
             {"--answers", outputs.answers},
             {"--report", with_job_name(options.report, file)}}) {
      if (!name.empty()) files.push_back({option, name, FileRole::kOutput});
    }
    for (const auto& [option, name] : stock_files(stock_for(options.stock, file))) {
      if (!name.empty()) files.push_back({option, name, FileRole::kOutput});
    }
  }
  return files;
}

void write_report(const SimOptions& options, const Report& report, const std::string& file) {
  if (options.report.empty()) return;
  write_json(with_job_name(options.report, file), std::span{&report, 1});
}

void print(const std::vector<Report>& reports, bool json) {
  if (!json) return print_table(stdout, reports, may_colour());
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Report& report : reports) all.push_back(to_json(report));
  terminal::write_data(dumped(reports.size() == 1 ? all[0] : all) + "\n");
}

ExitStatus simulate_all(const SimOptions& options) {
  if (options.job.files.size() > 1) {
    require_placeholder(options.outputs.trace, "--trace");
    require_placeholder(options.outputs.vcd, "--vcd");
    require_placeholder(options.outputs.svg, "--svg");
    require_placeholder(options.outputs.png, "--png");
    require_placeholder(options.report, "--report");
    require_placeholder(options.outputs.knots, "--knots");
    require_placeholder(options.outputs.answers, "--answers");
    for (const auto& [option, name] : stock_files(options.stock)) require_placeholder(name, option);
  }
  refuse_shared_files(files_of(options));
  const std::optional<stock::PocketTarget> target = stock_target_of(options.stock);
  const std::shared_ptr<const surface::Mesh> surface = stock_surface_of(options.stock);
  const JobsDone done = for_each_job(options.job, [&](const Job& job) {
    JobOutputs outputs = outputs_for(options, job.file);
    if (outputs.stock) {
      outputs.stock->target = target;
      outputs.stock->surface = surface;
    }
    Report report = simulate(job, outputs);
    write_report(options, report, job.file);
    return report;
  });
  if (!done.reports.empty()) print(done.reports, options.job.json);
  return finish(done);
}

}  // namespace

void add_sim_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "sim",
      "Run programs through the simulated controller and measure the motion.\n"
      "With several programs, {} in an output name stands for the name of each.");
  command->footer(
      "Examples:\n"
      "  kerfline sim part.nc --settings laser.settings --svg part.svg\n"
      "  kerfline sim part.nc --set '$110=6000' --report part.json --trace part.csv\n"
      "  kerfline sim *.nc --settings laser.settings --png 'pictures/{}.png'\n"
      "  kerfline sim pocket.nc --set '$32=0' --stock 0,0,120,80,0,-20 --tool 6 --stock-png "
      "left.png\n"
      "\n"
      "Exit status: 0 fine, 1 the program has faults or stopped in an alarm, 2 the call is wrong.");
  const auto options = std::make_shared<SimOptions>();
  options->job.add_to(*command);
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command->add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("--trace", options->outputs.trace, "Write every step as text");
  add_output("--vcd",
             options->outputs.vcd,
             "Write the edges of all pins as VCD for logic-analyser viewers");
  add_output("--report", options->report, "Write the report as JSON");
  add_output("--answers",
             options->outputs.answers,
             "Write the controller's answers, as a sender logs them");
  add_output("--knots",
             options->outputs.knots,
             "Write the positions of the axes, `time_s x y z a b c`, at each cell of the plan; "
             "only under G43.4 or with input shaping");
  add_output("--svg", options->outputs.svg, "Draw the cut path as SVG");
  add_output("--png", options->outputs.png, "Draw the cut path as PNG");
  command
      ->add_option(
          "--kerf",
          options->outputs.kerf_width_mm,
          "Width of the cut in the picture, mm; default: 0.1 for a laser, a thin line for a mill")
      ->check(in_range(0.0, 100.0, "mm"))
      ->type_name("WIDTH");
  add_stock_options(*command, options->stock);
  command->callback([options, &status] { status = simulate_all(*options); });
}

}  // namespace sim

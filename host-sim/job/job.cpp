#include "host-sim/job/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "firmware/machine/configuration.hpp"
#include "host-sim/job/axis_scale.hpp"
#include "host-sim/job/job_report.hpp"
#include "host-sim/job/knot_file.hpp"
#include "host-sim/job/measuring_error.hpp"
#include "host-sim/job/picture_choice.hpp"
#include "host-sim/job/tip_trace.hpp"
#include "host-sim/machine/machine_reading.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/energy_meter.hpp"
#include "host-sim/measure/motion_meter.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/measure/shaping_meter.hpp"
#include "host-sim/measure/tool_trace.hpp"
#include "host-sim/plot/path_recorder.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"
#include "host-sim/trace/trace_writer.hpp"
#include "host-sim/trace/vcd_writer.hpp"

namespace sim {
namespace {

/// Returns the greatest distance, in mm, between the tool and its planned position that shapers and
/// play may cause. A shaper moves the position of an axis by at most half of the acceleration times
/// the variance of the delays of its impulses. The plan must keep within the acceleration of the
/// axis.
double allowed_for_motors(const cnc::Settings& settings) {
  const cnc::motion::MotorStageSetting stage = cnc::motor_stage_from(settings);
  double sum = 0.0;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const auto impulses = cnc::motion::impulses_of(stage.shapers[axis]);
    double spread = 0.0;
    for (std::size_t i = 0; i < impulses.count; ++i) {
      const float off = impulses.delay_s[i] - impulses.mean_delay_s();
      spread += static_cast<double>(impulses.amplitude[i] * off * off);
    }
    const auto acceleration = static_cast<double>(settings.get(cnc::setting::kAcceleration, axis));
    const auto play = static_cast<double>(settings.get(cnc::setting::kBacklash, axis));
    const double off = 0.5 * acceleration * spread + play;
    sum += off * off;
  }
  return std::sqrt(sum);
}

/// Reports to the picture whether the machine drives a rapid, which cannot be concluded from the
/// pulses.
class MotionKindTeller final : public TraceSink {
 public:
  MotionKindTeller(const PathDeviation& follower, PathRecorder& recorder)
      : follower_{follower}, recorder_{recorder} {}

  void on_row(const TraceRow&) override {
    const PathPiece* piece = follower_.present_piece();
    if (piece != nullptr) recorder_.on_motion_kind(piece->travel == Travel::kRapid);
  }

 private:
  const PathDeviation& follower_;
  PathRecorder& recorder_;
};

/// Returns the length of the cuts of the path, mm, up to the line at which sending ended.
double cut_length(const ProgrammedPath& path, const RunResult& result) {
  const int end = result.refusals.empty() ? std::numeric_limits<int>::max()
                                          : static_cast<int>(result.refusals.front().line);
  double sum = 0.0;
  for (const PathPiece& piece : path.pieces) {
    if (piece.line < end) sum += cut_length(piece);
  }
  return sum;
}

void add_measured(const MotionMeter& meter, Report& report) {
  report.path_length_mm = meter.path_length();
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const AxisMotion motion = meter.axis(static_cast<cnc::Axis>(axis));
    report.axes[axis] = {.max_speed_mm_s = motion.greatest_speed,
                         .max_acceleration_mm_s2 = motion.greatest_acceleration,
                         .max_jerk_mm_s3 = motion.greatest_jerk,
                         .steps = motion.steps};
  }
}

/// Adds the bounds of the positions of the tool. The bounds of the motors would be wider, because
/// motors move farther to take up play.
void add_bounds(const ToolTrace& tool, const cnc::Settings& settings, Report& report) {
  const auto steps = steps_per_mm<double>(settings);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    report.axes[axis].min_mm = tool.lowest()[axis] / steps[axis];
    report.axes[axis].greatest_mm = tool.highest()[axis] / steps[axis];
  }
}

void add_deviation(const PathDeviation& deviation, Report& report) {
  report.max_path_deviation_mm = deviation.greatest_distance().value;
  report.max_path_deviation_at_s =
      static_cast<double>(deviation.greatest_distance().time_ns) * 1.0e-9;
}

/// Returns the options of the energy meter. The light is read from the power table at each moment,
/// because a program may change the table at its beginning.
EnergyMeter::Options beam_of(Simulator& simulator) {
  const cnc::Settings& settings = simulator.settings();
  const cnc::Machine& machine = simulator.machine();
  return {.max_speed = settings.get(cnc::setting::kMaxSpindleSpeed),
          .min_speed = settings.get(cnc::setting::kMinSpindleSpeed),
          .light = [&machine](float duty) {
            return static_cast<double>(machine.power_table().share_of(duty));
          }};
}

/// Returns whether the light is at the position at which the output of the beam is on. If delays
/// are set, the light is at another position, and the time in which the real beam reacts is not
/// known here. With shapers or backlash, the times of positions differ from those of the plan.
bool lights_at_once(const cnc::Settings& settings) {
  const auto zero = [&settings](std::uint16_t number) { return settings.get(number) == 0.0F; };
  return !zero(cnc::setting::kLaserMode) && zero(cnc::setting::kBeamOnDelay) &&
         zero(cnc::setting::kBeamOffDelay) && zero(cnc::setting::kBeamLag) &&
         zero(cnc::setting::kRotaryAxes) && allowed_for_motors(settings) <= 0.0;
}

/// Measures the energy of the light for each millimetre of the driven path. The driven path is used
/// instead of the programmed path, because a rounded corner is shorter than the programmed corner.
class BeamMeter {
 public:
  BeamMeter(const ProgrammedPath& programmed, Simulator& simulator)
      : path_{driven_path(programmed, cnc::limits_from(simulator.settings()))},
        deviation_{path_, steps_per_mm<double>(simulator.settings()), kNoExcess},
        energy_{path_, deviation_, steps_per_mm<double>(simulator.settings()), beam_of(simulator)} {
    simulator.add_sink(deviation_);
    simulator.add_sink(energy_);
  }

  void add_to(Report& report) const {
    const EnergyFigures figures = energy_.figures();
    if (figures.windows == 0) return;
    report.min_energy_ratio = figures.least;
    report.mean_energy_ratio = figures.mean;
    report.greatest_energy_ratio = figures.greatest;
  }

 private:
  /// Threshold of PathDeviation for the excess of an axis, mm. It is infinite, because BeamMeter
  /// does not search for excesses.
  static constexpr double kNoExcess = std::numeric_limits<double>::infinity();

  ProgrammedPath path_;
  PathDeviation deviation_;
  EnergyMeter energy_;
};

/// The requested files to which each step is written.
class StepFiles {
 public:
  StepFiles(const JobOutputs& outputs, Simulator& simulator) {
    if (!outputs.trace.empty()) {
      trace_ =
          std::make_unique<TraceWriter>(outputs.trace, steps_per_mm<float>(simulator.settings()));
      simulator.add_sink(*trace_);
    }
    if (!outputs.vcd.empty()) {
      vcd_ = std::make_unique<VcdWriter>(outputs.vcd);
      simulator.add_sink(*vcd_);
    }
  }

 private:
  std::unique_ptr<TraceWriter> trace_;
  std::unique_ptr<VcdWriter> vcd_;
};

void draw(const PathRecorder& recorder,
          const Report& report,
          const JobOutputs& outputs,
          const cnc::Settings& settings) {
  if (outputs.svg.empty() && outputs.png.empty()) return;
  const double usual_kerf = is_mill(settings) ? 0.0 : PictureOptions{}.kerf_width_mm;
  const PictureOptions options{.title = report.job,
                               .kerf_width_mm = outputs.kerf_width_mm.value_or(usual_kerf),
                               .cut_length_mm = report.cut_length_mm};
  if (!outputs.svg.empty()) write_svg(outputs.svg, recorder.path(), options);
  if (!outputs.png.empty()) write_png(outputs.png, draw_svg(recorder.path(), options));
}

/// Writes the lines that the controller sends to a file, if a file is named.
class AnswerFile {
 public:
  explicit AnswerFile(const std::string& name) {
    if (!name.empty()) file_.emplace(name);
  }

  void take(std::string_view line) {
    if (!file_) return;
    fmt::format_to(std::back_inserter(file_->buffer()), "{}\n", line);
    file_->drain_when_full();
  }
  void close() {
    if (file_) file_->close();
  }

 private:
  std::optional<OutputFile> file_;
};

/// Measures the effect of shaping on the plan, and writes the positions of the plan at the ends of
/// cells of time.
class CellWatch {
 public:
  /// Begins to observe the machine of the simulator.
  /// @param knots name of the file for the positions; empty if none is to be written
  CellWatch(const std::string& knots, Simulator& simulator)
      : name_{knots}, shaping_{steps_per_mm<double>(simulator.settings())} {
    simulator.machine().observe(&shaping_);
    if (knots.empty()) return;
    knots_.emplace(knots, steps_per_mm<double>(simulator.settings()), shaping_);
    simulator.machine().observe(&*knots_);
  }
  // Not copyable, because the machine has pointers to members of this object.
  CellWatch(const CellWatch&) = delete;
  CellWatch& operator=(const CellWatch&) = delete;
  ~CellWatch() = default;

  /// Adds the figures and warnings to a report, and closes the file.
  /// @pre the machine has stopped
  void add_to(Report& report) {
    report.max_shaping_error_mm = shaping_.greatest_distance();
    if (!knots_) return;
    knots_->close();
    if (!knots_->is_empty()) return;
    report.warnings.push_back(fmt::format(
        "{}: contains no positions, because neither G43.4 nor input shaping was active", name_));
  }

 private:
  std::string name_;
  ShapingMeter shaping_;
  std::optional<KnotFile> knots_;
};

/// Returns the path that a program describes. The tolerance of each piece includes the distance by
/// which the motors of the machine may deviate from the path.
ProgrammedPath path_for_machine(const std::string& text, const cnc::Settings& settings) {
  ProgrammedPath path = read_for_machine(text, settings);
  for (PathPiece& piece : path.pieces) piece.tolerance.motors = allowed_for_motors(settings);
  return path;
}

/// Adds the notes of the reader about words that it left out. If a line was refused, warns instead
/// that all figures end before this line.
void warn_of_reading(const Job& job,
                     const ProgrammedPath& path,
                     const RunResult& result,
                     Report& report) {
  if (result.refusals.empty()) {
    warn(job, path.notes, report);
  } else {
    report.warnings.push_back(fmt::format("{}: all figures end before line {}, which is refused",
                                          job.file,
                                          result.refusals.front().line));
  }
}

}  // namespace

Report simulate(const Job& job, const JobOutputs& outputs) {
  const ProgramText program = prepared(job);
  const std::string& text = program.text;
  AnswerFile answers{outputs.answers};
  Simulator simulator{text,
                      {.after_refusal = AfterRefusal::kStop,
                       .machine = job.machine,
                       .on_progress = job.on_progress,
                       .on_answer = [&answers](std::string_view line) { answers.take(line); }}};
  apply_settings(job.settings, simulator.machine());
  const ProgrammedPath path = path_for_machine(text, simulator.settings());
  PlayModel play{job.machine};
  play.place(simulator.settings());
  ToolTrace tool{play};
  CellWatch cells{outputs.knots, simulator};
  MotionMeter meter{steps_per_mm<double>(simulator.settings())};
  PathDeviation deviation{path, steps_per_mm<double>(simulator.settings())};
  PathRecorder recorder{steps_per_mm<float>(simulator.settings()),
                        shown_of(path, simulator.settings())};
  MotionKindTeller teller{deviation, recorder};
  simulator.add_sink(meter);
  simulator.add_sink(tool);
  TipTrace tip{simulator.machine(), deviation};
  tool.add_sink(tip);
  std::optional<BeamMeter> beam;
  if (lights_at_once(simulator.settings())) beam.emplace(path, simulator);
  if (!outputs.svg.empty() || !outputs.png.empty()) {
    tip.add_sink(teller);
    tip.add_sink(recorder);
  }
  std::optional<StockRun> stock;
  if (outputs.stock) {
    stock.emplace(*outputs.stock, path, deviation, simulator.settings());
    tip.add_sink(*stock);
  }
  const StepFiles step_files{outputs, simulator};

  const RunResult result = simulator.run();
  answers.close();
  Report report = report_on(job, program, result, path.refused, text);
  report.cut_length_mm = cut_length(path, result);
  warn_of_step_rates(job, simulator.settings(), report);
  warn_of_reading(job, path, result, report);
  add_measured(meter, report);
  add_measuring_errors(simulator.settings(), report);
  add_bounds(tool, simulator.settings(), report);
  add_deviation(deviation, report);
  report.tip = tip.tip();
  cells.add_to(report);
  if (beam) beam->add_to(report);
  draw(recorder, report, outputs, simulator.settings());
  if (stock) {
    stock->add_to(report, job.file);
    stock->write_files(report.job);
  }
  return report;
}

}  // namespace sim

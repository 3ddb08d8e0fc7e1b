#include "host-sim/cli/wall_joints.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/joints/joint_program.hpp"
#include "host-sim/machine/simulator.hpp"
#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kJointsFooter =
    "FILE is a program under G43.4, from `wall --layer` or from another source. Each line and arc\n"
    "of the tip becomes straight moves of X Y Z and the rotary axes, as few as keep the tip "
    "within\n"
    "--tip-tolerance of its path. They have inverse-time feeds (G93) and machine coordinates, so\n"
    "that the controller must have no work offset. Beam, spindle, coolant, dwells and stops are\n"
    "kept. Any other word is refused with its line.\n"
    "\n"
    "Example:\n"
    "  kerfline wall joints part.nc --settings five.settings --zero 0,0,-80 -o joints.nc";

struct JointsOptions {
  std::string file;
  std::string settings_file;
  std::vector<std::string> set;
  std::vector<double> zero{0.0, 0.0, 0.0};
  joints::JointOptions program;
  std::string output;
};

void print_figures(const std::string& file, const joints::JointFigures& figures) {
  terminal::print(stderr,
                  "{}: {} motions, {} moves of the axes, tip within {:.6f} mm, feeds take {}\n",
                  file,
                  figures.motions,
                  figures.moves,
                  figures.error_mm,
                  duration_text(figures.feed_s));
  if (!figures.bounds) return;
  std::string bounds;
  for (std::size_t axis = 0; axis < figures.bounds->low.size(); ++axis) {
    bounds += fmt::format("{}{} {:.3f} to {:.3f}",
                          axis == 0 ? "" : ", ",
                          "XYZABC"[axis],
                          figures.bounds->low[axis],
                          figures.bounds->high[axis]);
  }
  terminal::print(stderr, "{}\n", bounds);
}

ExitStatus run_joints(JointsOptions& options) {
  Simulator machine{"", {}};
  apply_settings(settings_of({}, options.settings_file, options.set), machine.machine());
  for (std::size_t axis = 0; axis < options.zero.size(); ++axis) {
    options.program.zero[axis] = options.zero[axis];
  }
  const std::string text = InputFiles::read(options.file);
  const joints::JointProgram program =
      joints::joint_program(text, options.file, machine.settings(), options.program);
  if (options.output.empty()) {
    terminal::write_data(program.text);
  } else {
    write_file(options.output, program.text);
  }
  print_figures(options.file, program.figures);
  return ExitStatus::kFine;
}

}  // namespace

void add_wall_joints_command(CLI::App& wall_command, ExitStatus& status) {
  CLI::App* command = wall_command.add_subcommand(
      "joints", "Write a five-axis program as moves of the axes, for other controllers.");
  command->footer(kJointsFooter);
  const auto options = std::make_shared<JointsOptions>();
  mark_file(
      command->add_option("FILE", options->file, "The program; - is standard input")->required(),
      FileRole::kInput);
  mark_file(
      command
          ->add_option("--settings",
                       options->settings_file,
                       "File of the machine's settings, `$N=value` on each line, with $900 to $917")
          ->type_name("FILE"),
      FileRole::kInput);
  command
      ->add_option("--set",
                   options->set,
                   "One setting of the machine, such as '$110=12000'; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--zero", options->zero, "Machine position of the zero of G54, mm; default: 0,0,0")
      ->delimiter(',')
      ->expected(3)
      ->check(in_range(-100'000.0, 100'000.0, "mm"))
      ->type_name("X,Y,Z");
  command
      ->add_option("--tip-tolerance",
                   options->program.tip_tolerance_mm,
                   "Greatest error of the tip between the ends of a move, mm")
      ->check(in_range(1.0e-5, 10.0, "mm"))
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--decimals", options->program.decimals, "Decimals of X, Y and Z")
      ->check(in_whole_range(3, 7))
      ->capture_default_str();
  mark_file(command
                ->add_option(
                    "-o,--output", options->output, "File of the program; default: standard output")
                ->type_name("FILE"),
            FileRole::kOutput);
  command->callback([options, &status] { status = run_joints(*options); });
}

}  // namespace sim

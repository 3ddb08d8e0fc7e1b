#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "firmware/protocol/identity.hpp"
#include "hal/host/replacing_file.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/help_formatter.hpp"
#include "host-sim/cli/standard_streams.hpp"
#include "host-sim/cli/unknown_word.hpp"
#include "host-sim/report/terminal.hpp"
#include "planner/base/contract.hpp"

void cnc::contract_failed(const char* condition, const char* file, int line) {
  sim::terminal::print(stderr, "kerfline: {}:{}: broken contract: {}\n", file, line, condition);
  std::abort();
}

namespace {

constexpr const char* kDescription =
    "Kerfline: the controller for laser cutters and mills, simulated.\n"
    "Runs the firmware itself in virtual time and measures its step pulses.";

constexpr const char* kProgramFooter =
    "Examples:\n"
    "  kerfline sim part.nc --settings laser.settings --svg part.svg\n"
    "  kerfline sim part.nc --set '$110=6000' --report part.json --trace part.csv\n"
    "  kerfline check *.nc --json\n"
    "  cat part.nc | kerfline check -\n"
    "  kerfline offset part.txt --distance 0.28 --svg part.svg -o cut.txt\n"
    "  kerfline drawing part.dxf --svg part.svg\n"
    "  kerfline cut part.dxf --material 'CSP 1N' --thickness 2 -o part.nc --svg part.svg\n"
    "  kerfline order e1x_6.pcglns --seconds 5 --json\n"
    "  kerfline serve --pty ttyKerfline --settings laser.settings\n"
    "  kerfline send part.nc --port /dev/ttyACM0\n"
    "  kerfline kerf advise --material 'CSP 1N' --thickness 2 --power 1800 --speed 4000\n"
    "\n"
    "Exit status: 0 fine, 1 the program has faults, 2 the call is wrong.";

int run(int argc, char** argv) {
  CLI::App app{kDescription, "kerfline"};
  app.footer(kProgramFooter);
  app.formatter(sim::help_formatter());
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string{cnc::identity::version()});
  sim::ExitStatus status = sim::ExitStatus::kFine;
  sim::add_sim_command(app, status);
  sim::add_check_command(app, status);
  sim::add_serve_command(app, status);
  sim::add_replay_command(app, status);
  sim::add_kerf_command(app, status);
  sim::add_offset_command(app, status);
  sim::add_drawing_command(app, status);
  sim::add_cut_command(app, status);
  sim::add_engrave_command(app, status);
  sim::add_order_command(app, status);
  sim::add_pocket_command(app, status);
  sim::add_surface_command(app, status);
  sim::add_wall_command(app, status);
  sim::add_send_command(app, status);
  sim::add_completion_command(app);
  sim::add_manual_command(app);
  app.parse_complete_callback([&app] { sim::refuse_shared_files(app); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      std::ostringstream text;
      const int code = app.exit(error, text);
      sim::terminal::write_data(text.str());
      return code;
    }
    const auto unknown = sim::unknown_word(app, {argv + 1, argv + argc});
    sim::print_error(unknown ? unknown->c_str() : error.what());
    sim::terminal::print(stderr, "Run with --help for more information.\n");
    return static_cast<int>(sim::ExitStatus::kUsage);
  }
  return static_cast<int>(status);
}

}  // namespace

int main(int argc, char** argv) {
  sim::prepare_standard_streams();
  hal::host::ReplacingFile::remove_unfinished_on_signals();
  constexpr int kUsage = static_cast<int>(sim::ExitStatus::kUsage);
  int status = kUsage;
  int output_error = 0;
  try {
    status = run(argc, argv);
  } catch (const std::system_error& error) {
    if (sim::standard_output_failed()) {
      output_error = error.code().value();
    } else {
      sim::print_error(error.what());
    }
  } catch (const std::exception& error) {
    sim::print_error(error.what());
  }
  return sim::finish_standard_output(output_error) ? status : kUsage;
}

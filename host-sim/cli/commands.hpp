#pragma once

namespace CLI {
class App;  // Forward declaration only, because CLI11's header takes seconds to compile.
}

namespace sim {

/// Exit status of the program.
enum class ExitStatus : int {
  kFine = 0,
  kFaults = 1,  ///< The program has faults, or the run ended in an alarm.
  kUsage = 2,   ///< The call itself, a setting or a file name is wrong.
};

/// Each function adds its subcommand, which sets `status` when it runs.
void add_sim_command(CLI::App& app, ExitStatus& status);
void add_check_command(CLI::App& app, ExitStatus& status);
void add_serve_command(CLI::App& app, ExitStatus& status);
void add_replay_command(CLI::App& app, ExitStatus& status);
void add_kerf_command(CLI::App& app, ExitStatus& status);
void add_offset_command(CLI::App& app, ExitStatus& status);
void add_drawing_command(CLI::App& app, ExitStatus& status);
void add_cut_command(CLI::App& app, ExitStatus& status);
void add_engrave_command(CLI::App& app, ExitStatus& status);
void add_order_command(CLI::App& app, ExitStatus& status);
void add_pocket_command(CLI::App& app, ExitStatus& status);
void add_send_command(CLI::App& app, ExitStatus& status);
void add_surface_command(CLI::App& app, ExitStatus& status);
void add_wall_command(CLI::App& app, ExitStatus& status);

/// Each function adds a subcommand that prints a text about all commands of `app`. `app` must
/// outlive the subcommand.
void add_completion_command(CLI::App& app);
void add_manual_command(CLI::App& app);

}  // namespace sim

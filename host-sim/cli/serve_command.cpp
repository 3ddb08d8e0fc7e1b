#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "hal/host/file_store.hpp"
#include "host-sim/can/socket_can_wire.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cli/probe_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/job/axis_scale.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/serve/can_transport.hpp"
#include "host-sim/serve/pty_transport.hpp"
#include "host-sim/serve/record_file.hpp"
#include "host-sim/serve/served_job.hpp"
#include "host-sim/serve/served_trace.hpp"
#include "host-sim/serve/server.hpp"
#include "host-sim/serve/slcan_wire.hpp"
#include "host-sim/serve/tcp_slcan_wire.hpp"
#include "host-sim/serve/tcp_transport.hpp"
#include "host-sim/serve/web_routes.hpp"
#include "host-sim/serve/web_transport.hpp"

namespace sim {
namespace {

constexpr const char* kServeFooter =
    "Examples:\n"
    "  kerfline serve --pty ttyKerfline --settings laser.settings\n"
    "  kerfline serve --tcp 2323 --ws 8000\n"
    "  kerfline serve --can vcan0 --node 17\n"
    "\n"
    "Prints a line for each link, such as `tcp 127.0.0.1:2323`, and then `ready`. One sender at a\n"
    "time controls the machine. The program ends on Ctrl-C or SIGTERM.\n"
    "If the connection to the sender is lost, the machine stops on its path with the beam off and\n"
    "is reset.\n"
    "If --record or --trace cannot be written, for instance on a full disk, a message is printed,\n"
    "the machine continues without this file, and the exit status is 2.";

constexpr int kLastNode = cnc::can::kLastNode;

/// Prefix of a --slcan value that is a TCP port instead of the name of a link.
constexpr std::string_view kTcp = "tcp:";

struct ServeOptions {
  std::string pty;
  std::string tcp;
  std::string ws;
  std::string can;
  std::string slcan;
  int node = 0;  ///< Number of the node; 0 for the number in the settings.
  double speed = 1.0;
  std::string machine;
  std::string settings_file;
  std::vector<std::string> set;
  std::string store;
  std::string record;
  std::string trace;
  ProbeOptions probe;
};

void add_ways_in(CLI::App& command, ServeOptions& options) {
  mark_file(command.add_option("--pty", options.pty, "Name of the serial port that is created")
                ->type_name("LINK"),
            FileRole::kKept);
  command
      .add_option(
          "--tcp",
          options.tcp,
          "Port for raw TCP, from this machine only unless an address is given; 0 is any free port")
      ->check(port_address())
      ->type_name("[ADDRESS:]PORT");
  command
      .add_option(
          "--ws",
          options.ws,
          "Port for the page and for senders over WebSocket, from this machine only unless\n"
          "an address is given; 0 is any free port")
      ->check(port_address())
      ->type_name("[ADDRESS:]PORT");
  command
      .add_option(
          "--can",
          options.can,
          "CAN interface of the kernel on which the controller is a node, such as can0 or vcan0")
      ->type_name("INTERFACE");
  mark_file(
      command
          .add_option("--slcan",
                      options.slcan,
                      "Name of the serial CAN adapter (slcan) that is created, or its TCP port as\n"
                      "tcp:[ADDRESS:]PORT, with the controller as the only node on its bus")
          ->type_name("LINK"),
      FileRole::kKept);
  command
      .add_option("--node",
                  options.node,
                  "Node number of the controller on the CAN bus; default: setting $859, which is "
                  "17 unless changed")
      ->check(in_whole_range(1, kLastNode))
      ->type_name("N");
}

void add_options(CLI::App& command, ServeOptions& options) {
  add_ways_in(command, options);
  command
      .add_option("--speed", options.speed, "Speed of the simulation, machine seconds per second")
      ->check(in_range(0.01, 1000.0, "s per s"))
      ->type_name("N")
      ->capture_default_str();
  const auto add_file = [&](FileRole role, const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), role);
  };
  add_machine_option(command, options.machine);
  add_file(FileRole::kInput,
           "--settings",
           options.settings_file,
           "File of the machine's settings, `$N=value` on each line");
  command
      .add_option(
          "--set", options.set, "One setting of the machine, such as '$110=12000'; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  add_file(FileRole::kKept,
           "--store",
           options.store,
           "File that keeps changed settings, offsets and start-up lines; default: they end with\n"
           "the run. --settings and --set override it");
  add_file(
      FileRole::kOutput, "--record", options.record, "Write the conversation for kerfline replay");
  add_file(FileRole::kOutput, "--trace", options.trace, "Write every step as text, as sim does");
  options.probe.add_to(command);
}

CanTransport::Controller node_of(Session& session) {
  const auto condition = [&session] {
    const auto alarm = static_cast<std::uint8_t>(session.controller().machine().alarm());
    return cnc::CanLink::Condition{.stopped = alarm != 0, .alarm = alarm};
  };
  const auto node = [&session] { return session.controller().firmware().can_node(); };
  const auto store_node = [&session](std::uint8_t number) {
    return session.controller().firmware().store_can_node(number);
  };
  return {.condition = condition, .node = node, .store_node = store_node};
}

void open_buses(const ServeOptions& options, Session& session, Reception& reception) {
  const auto add = [&](std::unique_ptr<CanWire> wire) {
    reception.add(std::make_unique<CanTransport>(std::move(wire), node_of(session), options.speed));
  };
  if (!options.can.empty()) {
    const std::uint8_t node = session.controller().firmware().can_node();
    add(std::make_unique<SocketCanWire>(options.can, cnc::can::heard_by_node(node)));
  }
  if (options.slcan.starts_with(kTcp)) {
    const std::string_view place = std::string_view{options.slcan}.substr(kTcp.size());
    add(std::make_unique<TcpSlcanWire>(parse_address(place)));
  } else if (!options.slcan.empty()) {
    add(std::make_unique<SlcanWire>(options.slcan));
  }
}

void open_ways_in(const ServeOptions& options, Reception& reception) {
  if (!options.pty.empty()) reception.add(std::make_unique<PtyTransport>(options.pty));
  if (!options.tcp.empty()) {
    reception.add(std::make_unique<TcpTransport>(parse_address(options.tcp)));
  }
}

void announce(const Reception& reception) {
  for (const auto& way : reception.ways_in()) {
    terminal::print("{} {}\n", way->kind(), way->address());
    if (way->kind() == "ws") terminal::print("page http://{}/\n", way->address());
  }
  terminal::print("ready\n");
  if (std::fflush(stdout) != 0) {
    throw std::system_error{errno, std::generic_category(), "standard output"};
  }
}

/// Returns all settings of the call. A --speed above 1 makes the time of the machine run faster,
/// but not the time of the sender. Therefore the time for which the sender may be silent is
/// multiplied by this factor.
std::vector<SettingChange> all_settings(const ServeOptions& options) {
  std::vector<SettingChange> changes =
      settings_of(options.machine, options.settings_file, options.set);
  if (options.node != 0) {
    changes.push_back({.number = cnc::setting::kCanNode,
                       .value = static_cast<float>(options.node),
                       .place = "--node"});
  }
  if (options.speed <= 1.0) return changes;
  const cnc::SettingInfo info = *cnc::find_setting(cnc::setting::kLinkWatchdog);
  const double scaled = std::round(info.standard * options.speed);
  const float allowed = std::min(static_cast<float>(scaled), info.most);
  changes.insert(changes.begin(), {.number = info.number, .value = allowed, .place = "--speed"});
  return changes;
}

ExitStatus serve(const ServeOptions& options) {
  const auto ways = {&options.pty, &options.tcp, &options.ws, &options.can, &options.slcan};
  if (std::all_of(ways.begin(), ways.end(), [](const auto* way) { return way->empty(); })) {
    throw std::invalid_argument(
        "serve: a link for senders is missing; give --pty LINK, --tcp PORT, --ws PORT, --can "
        "INTERFACE or --slcan LINK");
  }
  const std::vector<SettingChange> settings = all_settings(options);
  const auto surface = options.probe.read();
  MachineModel machine;
  options.probe.apply(surface, machine);
  const StopSignals stop;
  hal::host::MemoryStore memory;
  std::optional<hal::host::FileStore> file;
  if (!options.store.empty()) file.emplace(options.store);
  hal::host::MemoryStore& store = file ? *file : memory;
  ConversationSetting setting{.settings = settings,
                              .probe_plate_z_mm = machine.probe_plate_z_mm,
                              .probe_surface = {},
                              .records = store.records()};
  if (surface) setting.probe_surface = {.tip_mm = surface->tip_mm, .file = surface->bytes};
  Session session{machine, setting.settings, store};
  RecordFile record{options.record, setting, session};
  ServedJob job;
  LiveView view{session.controller(), job};
  Reception reception{session};
  reception.set_job(job);
  WebRoutes routes{session.controller(), view, reception, job};
  Server server{session, reception, options.speed};
  open_ways_in(options, reception);
  open_buses(options, session, reception);
  if (!options.ws.empty()) {
    auto web = std::make_unique<WebTransport>(parse_address(options.ws), routes);
    session.controller().add_sink(view);
    server.show(view, *web);
    reception.add(std::move(web));
  }
  std::optional<ServedTrace> trace;
  if (!options.trace.empty()) {
    trace.emplace(options.trace, steps_per_mm<float>(session.controller().machine().settings()));
    session.controller().add_sink(*trace);
  }
  announce(reception);
  server.run(stop);
  session.controller().end();
  const bool kept = record.close(session) && !(trace && trace->lost());
  return kept ? ExitStatus::kFine : ExitStatus::kUsage;
}

}  // namespace

void add_serve_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("serve",
                         "Run the controller in real time for G-code senders: over a serial\n"
                         "port, TCP or WebSocket, with a page to watch and to operate it.");
  command->footer(kServeFooter);
  const auto options = std::make_shared<ServeOptions>();
  add_options(*command, *options);
  command->callback([options, &status] { status = serve(*options); });
}

}  // namespace sim

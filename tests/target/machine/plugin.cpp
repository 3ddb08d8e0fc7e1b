// Entry points for QEMU. It loads this library, passes the options, and calls when its machine is
// complete and when it ends.

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <span>

#include "tests/target/machine/board.hpp"
#include "tests/target/machine/core_cycles.hpp"
#include "tests/target/machine/options.hpp"
#include "tests/target/machine/qemu.hpp"

namespace machine {
namespace {

/// Data of the C functions that QEMU calls. It is never destroyed, because QEMU's own exit comes
/// after the destruction of static objects.
struct Session {
  Order order;
  std::unique_ptr<Board> board;
  std::unique_ptr<Memories> memories;  // Replaces the board with the option memories_only.
  std::unique_ptr<CoreCycles> cycles;  // Works with `memories`, with the option cycles.
  qemu::Notifier ready{};
};

Session& session() {
  static Session* const kThe = new Session;
  return *kThe;
}

void on_machine_ready(qemu::Notifier*, void*) {
  Session& now = session();
  qemu::Object* const core = qemu::object_resolve_path_type("", "armv7m", nullptr);
  if (core == nullptr || qemu::object_resolve_path_type("", "stm32f405-soc", nullptr) == nullptr) {
    fmt::print(stderr, "machine: needs -M netduinoplus2\n");
    std::exit(1);
  }
  // A MemoryRegion begins with its Object.
  qemu::Object* const core_memory =
      qemu::object_resolve_path_component(core, "armv7m-container[0]");
  const Memory memory{qemu::get_system_memory(),
                      reinterpret_cast<qemu::MemoryRegion*>(core_memory)};
  if (now.order.options.memories_only) {
    now.memories = std::make_unique<Memories>(memory, now.order.options);
    if (now.cycles != nullptr) now.cycles->map(memory.core);
    return;
  }
  now.board = std::make_unique<Board>(now.order, memory, core);
  qemu::qemu_register_reset([](void*) { session().board->reset(); }, nullptr);
}

void on_end(qemu::PluginId, void*) {
  if (session().board != nullptr) session().board->finish();
}

bool take_arguments(std::span<char*> arguments) {
  Order& order = session().order;
  for (const char* argument : arguments) {
    if (const auto complaint = take_option(argument, order.options)) {
      fmt::print(stderr, "machine: {}\n", *complaint);
      return false;
    }
  }
  if (order.options.cycles && !order.options.memories_only) {
    fmt::print(stderr, "machine: cycles=on needs memories_only=on\n");
    return false;
  }
  const std::string& pins = order.options.pins;
  if (!pins.empty() && !read_pin_script(pins, order.pins)) return false;
  const std::string& frames = order.options.can_input;
  if (!frames.empty() && !read_frames(frames, order.frames)) return false;
  const std::string& trace = order.options.trace;
  if (trace.empty()) return true;
  order.trace = std::fopen(trace.c_str(), "w");
  if (order.trace == nullptr) fmt::print(stderr, "machine: cannot write {}\n", trace);
  return order.trace != nullptr;
}

}  // namespace
}  // namespace machine

extern "C" {

/// Version of the plug-in interface of QEMU 7.2.
[[gnu::visibility("default")]] extern const int qemu_plugin_version;
const int qemu_plugin_version = 1;

[[gnu::visibility("default")]] int qemu_plugin_install(qemu::PluginId id,
                                                       const qemu::PluginInfo* info,
                                                       int count,
                                                       char** arguments) {
  // A later interface means a later QEMU, whose structures may differ.
  if (info->version.cur != qemu_plugin_version || !info->system_emulation) {
    fmt::print(stderr, "machine: made for qemu-system-arm 7.2\n");
    return -1;
  }
  if (!machine::take_arguments({arguments, static_cast<std::size_t>(count)})) return -1;
  if (machine::session().order.options.cycles) {
    machine::session().cycles = std::make_unique<machine::CoreCycles>(id);
  }
  qemu::Notifier& ready = machine::session().ready;
  ready.notify = machine::on_machine_ready;
  qemu::qemu_add_machine_init_done_notifier(&ready);
  qemu::qemu_plugin_register_atexit_cb(id, machine::on_end, nullptr);
  return 0;
}
}

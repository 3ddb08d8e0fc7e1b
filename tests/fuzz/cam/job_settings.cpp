/// libFuzzer: random bytes as a recipe of `cut`, as a machine, as the form of programs that a
/// controller requires, and as the form of a test grid.

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/cut_recipe.hpp"
#include "host-sim/cut/machine_profile.hpp"
#include "host-sim/knowledge/test_grid_form.hpp"
#include "host-sim/post/post.hpp"
#include "tests/fuzz/drawing_judge.hpp"

namespace {

/// A file in memory, because recipes are read by name.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text) : handle_{memfd_create("fuzz", 0)} {
    const ssize_t written = write(handle_, text.data(), text.size());
    fuzz::require_drawn(written == static_cast<ssize_t>(text.size()), "memory takes a file");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(handle_); }

  [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(handle_); }

 private:
  int handle_;
};

void judge_recipe(const std::string& text) {
  const MemoryFile file{text};
  CLI::App command;
  const auto options = std::make_shared<sim::CutCommandOptions>();
  sim::add_cut_options(command, options);
  options->recipe.file = file.name();
  sim::apply_recipe(command, *options);
}

void judge_machine(const std::string& text) {
  const auto profile = sim::cut::read_machine_profile(text, "fuzz");
  const auto bed = profile.bed();
  fuzz::require_drawn(bed.high.x() > bed.low.x() && bed.high.y() > bed.low.y(), "a bed has room");
  fuzz::require_drawn(std::isfinite(profile.full_power_w), "a power is a number");
}

void judge_post(const std::string& text) { static_cast<void>(sim::post::read_post(text, "fuzz")); }

void judge_grid(const std::string& text) {
  const sim::MeasuredGrid grid = sim::read_form(text, "fuzz", {"fuzz", "2026-01-31"});
  fuzz::require_drawn(!grid.operations.empty(), "a form has a good square");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{reinterpret_cast<const char*>(data), size};
  for (const auto judge : {judge_recipe, judge_machine, judge_post, judge_grid}) {
    try {
      judge(text);
    } catch (const std::invalid_argument& refusal) {
      fuzz::require_refusal(refusal);
    }
  }
  return 0;
}

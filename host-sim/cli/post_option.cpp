#include "host-sim/cli/post_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "host-sim/cli/file_options.hpp"

namespace sim {

void PostOption::add_to(CLI::App& command) {
  mark_file(command
                .add_option("--post",
                            file_,
                            "File of the form in which a controller requires programs: heading, "
                            "line numbers,\narcs, words")
                ->type_name("FILE"),
            FileRole::kInput);
}

void PostOption::read(const CLI::App& command, InputFiles& inputs, unsigned& decimals) {
  if (file_.empty()) return;
  post_ = post::read_post(inputs.read_and_add("post", file_), file_);
  if (!post_->decimals) return;
  const unsigned most = *post_->decimals;
  if (command.count("--decimals") > 0 && decimals > most) {
    throw std::invalid_argument(fmt::format(
        "--decimals {}: the post {} allows {}; give at most that many", decimals, file_, most));
  }
  decimals = std::min(decimals, most);
}

std::string PostOption::applied_to(std::string program) const {
  return post_ ? post::posted(program, *post_) : std::move(program);
}

}  // namespace sim

#include "host-sim/send/take_up.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace sim {

void Standing::read(std::string_view words) {
  if (words == "$32=1") laser = true;
  if (words.starts_with("<Alarm")) in_alarm = true;
  if (words.starts_with("<Idle")) in_alarm = false;
  constexpr std::string_view kResume = "[RESUME:";
  if (!words.starts_with(kResume)) return;
  words.remove_prefix(kResume.size());
  std::from_chars(words.data(), words.data() + words.size(), line);
  known = words.ends_with("|can]");
}

std::vector<JobLine> standing_questions(bool resume) {
  std::vector<JobLine> questions{{.text = "$$"}};
  if (resume) questions.push_back({.text = "$RESUME"});
  return questions;
}

std::size_t interrupted_at(const JobLines& job, const Standing& standing) {
  if (standing.line == 0) {
    throw std::invalid_argument("the controller knows of no job that was interrupted");
  }
  if (standing.line > job.size()) {
    throw std::invalid_argument(fmt::format(
        "the job has {} lines, but line {} was interrupted: this is not the interrupted job",
        job.size(),
        standing.line));
  }
  if (!standing.known) {
    throw std::invalid_argument("the machine may have lost its position: home it first");
  }
  return standing.line - 1;
}

Approach lines_before(const JobLines& job,
                      std::size_t index,
                      const Standing& standing,
                      bool resume) {
  Approach approach = approach_to(job, index, standing.laser);
  std::vector<JobLine> lines;
  if (standing.in_alarm) lines.push_back({.text = "$X"});
  if (resume) lines.push_back({.text = fmt::format("$RESUME={}", standing.line)});
  approach.lines.insert(approach.lines.begin(), lines.begin(), lines.end());
  return approach;
}

}  // namespace sim

#include "firmware/machine/progress.hpp"

#include <bit>

#include "planner/base/crc32.hpp"

namespace cnc {

std::uint32_t KeptProgress::check() const {
  Crc32 crc;
  crc.add(line_);
  for (const std::int32_t steps : steps_) crc.add(static_cast<std::uint32_t>(steps));
  return crc.value();
}

void KeptProgress::keep(const Progress& progress) {
  line_ = std::bit_cast<std::uint32_t>(progress.line);
  steps_ = progress.steps;
  check_ = check();
}

Progress KeptProgress::progress() const {
  if (check_ != check()) return {};
  return {.line = std::bit_cast<motion::SourceLine>(line_), .steps = steps_};
}

}  // namespace cnc

#include "firmware/machine/program_progress.hpp"

namespace cnc {

ProgramProgress::ProgramProgress(KeptProgress* kept) : kept_{kept} {
  if (kept != nullptr) noted_ = kept->progress();
}

void ProgramProgress::set(const Progress& progress) {
  noted_ = progress;
  place_is_kept_ = false;
  if (kept_ != nullptr) kept_->keep(noted_);
}

void ProgramProgress::note(motion::SourceLine line, const AxisArray<std::int32_t>& steps) {
  noted_.line = line;
  place_is_kept_ = true;
  note(steps);
}

void ProgramProgress::note(const AxisArray<std::int32_t>& steps) {
  if (!noted_.any()) return;
  noted_.steps = steps;
  if (kept_ != nullptr) kept_->keep(noted_);
}

}  // namespace cnc

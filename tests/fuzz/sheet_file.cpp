/// libFuzzer: any bytes as a sheet file, whose drawings are all the same small one.

#include <cstddef>
#include <cstdint>

#include "host-sim/sheet/place_parts.hpp"
#include "host-sim/sheet/sheet_check.hpp"
#include "tests/fuzz/drawing_judge.hpp"

namespace {

constexpr const char* kPart =
    "<svg width=\"9mm\" height=\"9mm\" viewBox=\"0 0 9 9\"><circle cx=\"4\" cy=\"4\" r=\"3\"/>"
    "<path d=\"M4 3H5V5Z\"/></svg>";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sim::sheet;
  const std::string text{reinterpret_cast<const char*>(data), size};
  const Sheet sheet = read_sheet("fuzz", text);
  std::size_t copies = 0;
  for (const SheetPart& part : sheet.parts) copies += part.places.size();
  fuzz::require_drawn(copies <= kMaxCopies, "copies are bounded");
  fuzz::require_drawn(!sheet.parts.empty() || !sheet.faults.empty(), "no parts without a reason");
  // More copies test nothing new, and take seconds.
  if (copies > 200) return 0;
  const auto read = [](const std::string& /*name*/) { return std::string{kPart}; };
  const sim::drawing::Drawing drawn = place_parts(sheet, read, {.effort = 0.02});
  for (const auto& contour : drawn.contours) {
    fuzz::judge_contour(drawn, contour);
    fuzz::require_drawn(contour.entity.part < drawn.parts.size(), "each part has a name");
  }
  std::vector<ContourUse> uses;
  for (const auto& contour : drawn.contours) uses.push_back({true, contour.closed, 0.3});
  for (const auto& fault : check_places(drawn, uses)) {
    fuzz::require_drawn(!to_string(fault, "fuzz").empty() && !fault.reason.empty(), "with reasons");
  }
  const Sheet again = read_sheet("fuzz", text_of(sheet));
  if (sheet.faults.empty()) fuzz::require_drawn(again.faults.empty(), "what is written is read");
  return 0;
}

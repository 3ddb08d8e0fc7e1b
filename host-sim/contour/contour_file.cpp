#include "host-sim/contour/contour_file.hpp"

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim {

Contour read_contour_file(const std::string& file) {
  return contour_from_text(read_text(file), file == "-" ? "standard input" : file);
}

}  // namespace sim

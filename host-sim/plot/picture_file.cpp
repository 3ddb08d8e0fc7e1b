#include "host-sim/plot/picture_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <stdexcept>

#include "host-sim/plot/png.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

/// Returns the ending of the name of a file, which begins with its last dot, in lower case; empty
/// if there is no ending.
std::string end_of(const std::string& file) {
  std::string end = std::filesystem::path{file}.extension().string();
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return end;
}

}  // namespace

void require_picture_name(std::string_view option, const std::string& file) {
  const std::string end = end_of(file);
  if (end.empty() || end == ".svg" || end == ".png") return;
  throw std::invalid_argument(fmt::format(
      "{} {}: is no format of a picture; use a name that ends in .svg or .png", option, file));
}

void write_picture(const std::string& file, const std::string& svg) {
  if (end_of(file) == ".png") {
    write_png(file, svg);
  } else {
    write_file(file, svg);
  }
}

}  // namespace sim

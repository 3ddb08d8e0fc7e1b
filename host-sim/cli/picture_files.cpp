#include "host-sim/cli/picture_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "host-sim/trace/input_file.hpp"

namespace sim {

namespace fs = std::filesystem;

std::string file_beside(const std::string& drawing, const std::string& name) {
  return (fs::path{drawing}.parent_path() / name).string();
}

drawing::ReadBeside reader_beside(const std::string& drawing) {
  if (drawing == "-") return {};
  return [drawing](const std::string& name) {
    const std::string file = file_beside(drawing, name);
    std::error_code is_none;
    const std::uintmax_t size = fs::file_size(file, is_none);
    if (!is_none && size > drawing::kMaxBytes) {
      throw std::invalid_argument(
          fmt::format("{} has more than {} MiB", file, drawing::kMaxBytes >> 20));
    }
    return read_bytes(file);
  };
}

}  // namespace sim

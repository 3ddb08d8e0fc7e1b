#include "host-sim/cli/input_files.hpp"

#include <algorithm>
#include <filesystem>

#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

/// Returns the name of a file relative to the folder of the program; unchanged if the program is a
/// stream.
std::string named_from_program(const std::string& program, const std::string& file) {
  if (file == "-" || program.empty()) return file;
  const auto absolute = [](const std::string& name) {
    return std::filesystem::absolute(name).lexically_normal();
  };
  return absolute(file).lexically_proximate(absolute(program).parent_path()).string();
}

}  // namespace

std::string InputFiles::read(const std::string& file, bool may_be_packed) {
  return read_text(file, may_be_packed);
}

void InputFiles::add(const char* kind, const std::string& file, const std::string& text) {
  ProgramDigest digest{kind, digest_of(text), named_from_program(program_, file)};
  if (std::ranges::find(digests_, digest) == digests_.end()) digests_.push_back(std::move(digest));
}

std::string InputFiles::read_and_add(const char* kind, const std::string& file) {
  std::string text = read(file);
  add(kind, file, text);
  return text;
}

}  // namespace sim

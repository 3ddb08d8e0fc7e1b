#include "host-sim/job/program_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "host-sim/job/text_hash.hpp"
#include "host-sim/measure/program_line.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

constexpr std::string_view kDigestMark = "(kerfline digest ";
constexpr std::size_t kDigestDigits = 16;
constexpr std::array<std::string_view, 10> kFileKinds{"drawing",
                                                      "sheet",
                                                      "layers",
                                                      "rules",
                                                      "tools",
                                                      "surface",
                                                      "boundary",
                                                      "part",
                                                      "picture",
                                                      "post"};

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view{" ._-/,+@#"}.find(c) != std::string_view::npos;
}

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    text += is_plain(c) ? std::string(1, c) : fmt::format("={:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

std::string unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const bool is_code = text[i] == '=' && i + 2 < text.size();
    const char* const end = is_code ? text.data() + i + 3 : nullptr;
    if (is_code && std::from_chars(text.data() + i + 1, end, byte, 16).ptr == end) {
      name += static_cast<char>(byte);
      i += 2;
    } else {
      name += text[i];
    }
  }
  return name;
}

bool is_digest(std::string_view text) {
  return text.size() == kDigestDigits && std::ranges::all_of(text, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

std::optional<ProgramDigest> digest_from(std::string_view line) {
  if (!line.starts_with(kDigestMark)) return {};
  line.remove_prefix(kDigestMark.size());
  const std::size_t end = line.find(')');
  const std::size_t equals = line.find('=');
  if (end == std::string_view::npos || equals > end) return {};
  const std::string_view value = line.substr(equals + 1, end - equals - 1);
  const std::string_view digest = value.substr(0, value.find(' '));
  if (!is_digest(digest) || value.size() < digest.size() + 2) return {};
  return ProgramDigest{std::string{line.substr(0, equals)},
                       std::string{digest},
                       unescaped(value.substr(digest.size() + 1))};
}

bool is_below_folder(const std::filesystem::path& name) {
  return name.is_relative() && std::ranges::find(name, "..") == name.end();
}

/// Returns the digest of the present content of a file; empty if the file does not exist, cannot be
/// read, is no regular file or is too large.
std::optional<std::string> digest_now(const std::filesystem::path& file) {
  std::error_code is_none;
  if (!std::filesystem::is_regular_file(file, is_none)) return {};
  const std::uintmax_t size = std::filesystem::file_size(file, is_none);
  if (is_none || size > kMaxDigestBytes) return {};
  try {
    return digest_of(read_bytes(file.string()));
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

std::string text_of(const ProgramDigest& digest) {
  return fmt::format("kerfline digest {}={} {}", digest.kind, digest.digest, escaped(digest.name));
}

nlohmann::ordered_json json_of(const std::vector<ProgramDigest>& digests) {
  auto rows = nlohmann::ordered_json::array();
  for (const ProgramDigest& digest : digests) {
    rows.push_back({{"kind", digest.kind}, {"digest", digest.digest}, {"name", digest.name}});
  }
  return rows;
}

std::vector<ProgramDigest> digests_in(std::string_view program) {
  std::vector<ProgramDigest> digests;
  while (!program.empty()) {
    std::string_view line = take_line(program);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty() || line.front() == ';' || line.front() == '%') continue;
    if (line.front() != '(') break;
    if (auto digest = digest_from(line)) digests.push_back(std::move(*digest));
  }
  return digests;
}

std::string digest_of(std::string_view text) { return fmt::format("{:016x}", text_hash(text)); }

std::string digest_of(const cnc::Settings& settings) {
  std::string text;
  for (const int number : {cnc::setting::kMaxSpindleSpeed + 0,
                           cnc::setting::kRate + 0,
                           cnc::setting::kRate + 1,
                           cnc::setting::kAcceleration + 0,
                           cnc::setting::kAcceleration + 1}) {
    text += fmt::format("${}={:.3f}\n", number, settings.get(static_cast<std::uint16_t>(number)));
  }
  return digest_of(text);
}

std::vector<std::string> stale_inputs(std::string_view program,
                                      const std::string& folder,
                                      DigestFiles files,
                                      const cnc::Settings* settings) {
  std::vector<std::string> warnings;
  for (const ProgramDigest& digest : digests_in(program)) {
    if (digest.kind == "settings" && digest.name == "given" && settings != nullptr &&
        digest_of(*settings) != digest.digest) {
      warnings.emplace_back(
          "the settings ($30, $110, $111, $120, $121) differ from those for which this program was "
          "made; cut it again with the --settings of the machine");
    }
    if (std::ranges::find(kFileKinds, digest.kind) == kFileKinds.end()) continue;
    const std::filesystem::path name{digest.name};
    if (digest.name == "-" || (files == DigestFiles::kBelowFolder && !is_below_folder(name))) {
      continue;
    }
    const auto now = digest_now(std::filesystem::path{folder} / name);
    if (!now || *now == digest.digest) continue;
    warnings.push_back(
        fmt::format("the {} {} has changed since this program was made; cut it again",
                    digest.kind,
                    printable_line(digest.name)));
  }
  return warnings;
}

std::string folder_of(const std::string& program) {
  return program == "-" ? std::string{} : std::filesystem::path{program}.parent_path().string();
}

}  // namespace sim

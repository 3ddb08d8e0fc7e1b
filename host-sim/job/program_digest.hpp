#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// Identity of one input from which a program was made. The heading of a program has a comment for
/// each input: `(kerfline digest drawing=0123456789abcdef plate.svg)`.
struct ProgramDigest {
  /// Kind of the input: `drawing`, `sheet`, `layers`, `rules`, `tools`, `post`, `surface`, `kerf`
  /// or `settings`.
  std::string kind;
  std::string digest;  ///< 16 hexadecimal digits; see digest_of().
  /// Name of the file, relative to the folder of the program. For a kerf, the name of the material;
  /// for settings, `given` or `default`.
  std::string name;

  [[nodiscard]] bool operator==(const ProgramDigest& other) const = default;
};

/// Returns the comment's text without its brackets. Bytes of the name that a comment cannot
/// contain, and `=`, are written as `=XX` in hexadecimal.
[[nodiscard]] std::string text_of(const ProgramDigest& digest);

/// Returns a row for each digest, with its kind, digest and name.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<ProgramDigest>& digests);

/// Reads the digests in the comments at the top of a program, up to its first words of G-code.
/// Skips comments that are no digest.
[[nodiscard]] std::vector<ProgramDigest> digests_in(std::string_view program);

/// Returns the digest of a text: its text_hash() in 16 hexadecimal digits.
[[nodiscard]] std::string digest_of(std::string_view text);

/// Returns the digest of the settings that decide power and time in the plane: $30, and $110, $111,
/// $120 and $121. Every Grbl has these settings.
[[nodiscard]] std::string digest_of(const cnc::Settings& settings);

/// The files that may be read to see whether they changed.
enum class DigestFiles : std::uint8_t {
  kAny,          ///< All files that the program names.
  kBelowFolder,  ///< Only files below the folder: the program came from elsewhere.
};

/// Returns a warning for each input file of the program that still exists and has another digest
/// now. Adds a warning if the program was made for given settings and those of the machine differ.
/// Files larger than kMaxDigestBytes are not read.
/// @param folder folder to which the names of files are relative; empty: the current one
/// @param settings of the machine; null where they are not known
[[nodiscard]] std::vector<std::string> stale_inputs(std::string_view program,
                                                    const std::string& folder,
                                                    DigestFiles files,
                                                    const cnc::Settings* settings);

inline constexpr std::uintmax_t kMaxDigestBytes = std::uintmax_t{256} << 20;

/// Returns the folder of a program, to which the names in its digests are relative; empty for `-`.
[[nodiscard]] std::string folder_of(const std::string& program);

}  // namespace sim

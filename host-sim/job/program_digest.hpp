#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// The digest of one input from which a program was made, to detect later changes of this input.
/// The heading of a program contains a comment for each input: `(kerfline digest
/// drawing=0123456789abcdef plate.svg)`.
struct ProgramDigest {
  /// Kind of the input: `drawing`, `sheet`, `layers`, `rules`, `tools`, `post`, `surface`, `kerf`
  /// or `settings`.
  std::string kind;
  std::string digest;  ///< 16 hexadecimal digits; see digest_of().
  /// Name of the input: the name of a file, relative to the folder of the program; for a kerf, the
  /// name of the material; for settings, `given` or `default`.
  std::string name;

  [[nodiscard]] bool operator==(const ProgramDigest& other) const = default;
};

/// Returns the text of the comment for a digest, without brackets. In the name, `=` and bytes that
/// a comment cannot contain are written as `=XX` in hexadecimal.
[[nodiscard]] std::string text_of(const ProgramDigest& digest);

/// Returns a JSON list with an object for each digest, which contains its kind, digest and name.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<ProgramDigest>& digests);

/// Returns the digests from the comments at the top of a program, before its first words of G-code.
/// Skips other comments.
[[nodiscard]] std::vector<ProgramDigest> digests_in(std::string_view program);

/// Returns the digest of a text: its text_hash() in 16 hexadecimal digits.
[[nodiscard]] std::string digest_of(std::string_view text);

/// Returns the digest of the settings that determine power and times of motions in the XY plane:
/// $30, $110, $111, $120 and $121. Every Grbl has these settings.
[[nodiscard]] std::string digest_of(const cnc::Settings& settings);

/// The files that may be read to check whether they have changed.
enum class DigestFiles : std::uint8_t {
  kAny,  ///< All files that the program names.
  /// Only files below the folder of the program. This value is for a program that was received from
  /// another computer.
  kBelowFolder,
};

/// Returns a warning for each input file of the program that exists and whose present digest is
/// different. Adds a warning if the program was made for given settings and the settings of the
/// machine differ from them. Files larger than kMaxDigestBytes are not read.
/// @param folder folder to which the names of files are relative; empty for the current folder
/// @param settings settings of the machine; null if they are not known
[[nodiscard]] std::vector<std::string> stale_inputs(std::string_view program,
                                                    const std::string& folder,
                                                    DigestFiles files,
                                                    const cnc::Settings* settings);

inline constexpr std::uintmax_t kMaxDigestBytes = std::uintmax_t{256} << 20;

/// Returns the folder of a program, to which the names in its digests are relative; empty for `-`.
[[nodiscard]] std::string folder_of(const std::string& program);

}  // namespace sim

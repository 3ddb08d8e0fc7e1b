#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// The identity of one thing that a program was made from. In the heading of a program it is a
/// comment of its own: `(kerfline digest drawing=0123456789abcdef plate.svg)`.
struct ProgramDigest {
  /// `drawing`, `sheet`, `layers`, `rules`, `tools`, `post`, `surface`, `kerf` or `settings`.
  std::string kind;
  std::string digest;  ///< 16 hexadecimal digits; see digest_of().
  /// Name of the file, from the folder of the program; of a kerf that of the material; `given` or
  /// `default` of settings.
  std::string name;

  [[nodiscard]] bool operator==(const ProgramDigest& other) const = default;
};

/// The comment's text without its brackets. Bytes of the name that a comment cannot carry, and `=`,
/// are written as `=XX` in hexadecimal.
[[nodiscard]] std::string text_of(const ProgramDigest& digest);

/// Returns a row for each digest, with its kind, digest and name.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<ProgramDigest>& digests);

/// Reads the digests in the comments at the top of a program, up to its first words of G-code.
/// Comments that are no such digest are passed over.
[[nodiscard]] std::vector<ProgramDigest> digests_in(std::string_view program);

/// Returns the digest of a text: its text_hash() in 16 hexadecimal digits.
[[nodiscard]] std::string digest_of(std::string_view text);

/// Returns the digest of the settings that decide power and time in the plane: $30, and $110, $111,
/// $120 and $121. Any Grbl has them.
[[nodiscard]] std::string digest_of(const cnc::Settings& settings);

/// The files that may be read to see whether they changed.
enum class DigestFiles : std::uint8_t {
  kAny,          ///< All that the program names.
  kBelowFolder,  ///< Only those below the folder: the program came from elsewhere.
};

/// Returns a warning for each file that the program was made from, that is still there and has
/// another digest now; and one for the settings of the machine, if the program was made for given
/// settings and they differ. Files larger than kMaxDigestBytes are not read.
/// @param folder where the names of files begin; empty: the current one
/// @param settings of the machine; null where they are not known
[[nodiscard]] std::vector<std::string> stale_inputs(std::string_view program,
                                                    const std::string& folder,
                                                    DigestFiles files,
                                                    const cnc::Settings* settings);

inline constexpr std::uintmax_t kMaxDigestBytes = std::uintmax_t{256} << 20;

/// Returns the folder of a program, where the names of its digests begin; empty for `-`.
[[nodiscard]] std::string folder_of(const std::string& program);

}  // namespace sim

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "firmware/protocol/reply.hpp"
#include "firmware/store/kerf_tables.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace cnc {

/// A part of the image of a kerf table. Its text is `0:4B465401…`: the number of the part, then its
/// bytes in hexadecimal.
struct KerfPart {
  std::size_t number = 0;
  std::array<std::byte, KerfTables::kPartBytes> bytes{};
  std::size_t size = 0;
};
/// Reads a part. Returns false if `text` is not the text of a KerfPart.
[[nodiscard]] bool read_kerf_part(std::string_view text, KerfPart& part);
/// Writes the text of a part, which read_kerf_part() reads.
void put_kerf_part(Reply& reply, std::size_t number, std::span<const std::byte> bytes);

/// A question about a kerf width. Its text is, for example, `CSP 1N,2.0,1800,4000`: name of the
/// table, thickness in mm, power in W, speed in mm/min. The numbers have at most three decimals.
struct KerfQuestion {
  std::string_view name{};
  kerf::Condition condition{};
};
/// Reads a question. Returns nothing if `text` is not the text of a KerfQuestion.
[[nodiscard]] std::optional<KerfQuestion> read_kerf_question(std::string_view text);

/// Writes a summary of a table, such as `[KERF:CSP 1N|W/(mm/min)|T 0.5-2|P 1200-1800|built in]`,
/// with thickness in mm and power in W.
void put_kerf_table(Reply& reply, const kerf::TableView<float>& table, bool built_in);
/// Writes the reason of a refusal, such as `speeds from 3000 to 5000 mm/min are permissible`.
void put_kerf_refusal(Reply& reply, const kerf::Refusal& refusal);
/// Writes the fault of a table, such as `kerf table has 9 thicknesses, capacity 8`.
void put_kerf_fault(Reply& reply, const kerf::TableFault& fault);

}  // namespace cnc

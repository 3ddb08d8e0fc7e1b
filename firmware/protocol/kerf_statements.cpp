#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/kerf_text.hpp"
#include "firmware/protocol/line_protocol.hpp"
#include "firmware/protocol/sender_words.hpp"

/// Executes the statements about kerf tables, `$K…`. They are allowed only at rest, because reading
/// and writing flash takes long.
namespace cnc {

void LineProtocol::take_kerf_statement(const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::kListKerfTables:
      listing_.begin(ListingKind::kKerfTables);
      return acknowledge();
    case StatementKind::kWriteKerfPart:
      return write_kerf_part(statement);
    case StatementKind::kKeepKerfTable:
      return keep_kerf_table();
    case StatementKind::kReadKerfTable:
      return read_kerf_table(statement);
    case StatementKind::kAskKerf:
      return ask_kerf(statement);
    case StatementKind::kEraseKerfTable:
      return erase_kerf_table(statement);
    default:
      return refuse(error_number::kNoSuchStatement);
  }
}

void LineProtocol::refuse_kerf(const KerfTables::Trouble& trouble, std::uint16_t column) {
  const bool failed = trouble.tables == KerfTablesError::kStoreFailed;
  if (failed) return refuse(error_number::kStoreFailed);
  Reply reason = begin_reason(column);
  if (trouble.tables) {
    reason.text(describe(*trouble.tables));
  } else if (trouble.table) {
    put_kerf_fault(reason, *trouble.table);
  }
  refuse(error_number::kBadNumber, reason);
}

void LineProtocol::write_kerf_part(const Statement& statement) {
  KerfPart part;
  if (!read_kerf_part(statement.text, part)) {
    return refuse(
        error_number::kBadNumber, statement.column, "not a part of the form n:hex digits");
  }
  const auto trouble = kerf_.take_part(part.number, std::span{part.bytes}.first(part.size));
  if (trouble) return refuse_kerf(trouble, statement.column);
  acknowledge();
}

void LineProtocol::keep_kerf_table() {
  const auto trouble = kerf_.check();
  if (trouble) return refuse_kerf(trouble, 1);
  if (confuses_senders(kerf_.candidate())) {
    return refuse(error_number::kBadNumber, 1, "senders would misread the name of this table");
  }
  if (const auto error = kerf_.keep()) return refuse_kerf({.tables = error}, 1);
  acknowledge();
}

/// Erases a kerf table. `*` erases all tables, including damaged tables, which have no readable
/// name.
void LineProtocol::erase_kerf_table(const Statement& statement) {
  if (statement.text == "*") {
    if (!kerf_.forget_all()) return refuse(error_number::kStoreFailed);
    return acknowledge();
  }
  if (const auto error = kerf_.forget(statement.text)) {
    return refuse_kerf({.tables = error}, statement.column);
  }
  acknowledge();
}

void LineProtocol::read_kerf_table(const Statement& statement) {
  const auto found = kerf_.find(statement.text);
  if (!found.ok()) return refuse_kerf({.tables = found.error()}, statement.column);
  if (found.value() < KerfTables::built_in()) {
    return refuse_kerf({.tables = KerfTablesError::kBuiltIn}, statement.column);
  }
  listing_.begin(ListingKind::kKerfImage, static_cast<std::uint16_t>(found.value()));
  acknowledge();
}

void LineProtocol::ask_kerf(const Statement& statement) {
  const auto question = read_kerf_question(statement.text);
  if (!question) {
    return refuse(error_number::kBadNumber,
                  statement.column,
                  "not of the form name,mm,W,mm/min with at most three decimals");
  }
  const auto found = kerf_.find(question->name);
  if (!found.ok()) return refuse_kerf({.tables = found.error()}, statement.column);
  const auto table = kerf_.table(found.value());
  if (!table.ok()) return refuse_kerf({.tables = table.error()}, statement.column);
  const auto width = kerf::kerf_width(table.value(), question->condition);
  if (!width.ok()) {
    Reply reason = begin_reason(statement.column);
    put_kerf_refusal(reason, width.error());
    return refuse(error_number::kBadNumber, reason);
  }
  constexpr std::uint32_t kMinDecimals = 3;
  Reply reply = begin_answer();
  reply.text("[KERF:").text(question->name).letter('|').value(width.value(), kMinDecimals);
  answer(reply.text(" mm]").end());
  acknowledge();
}

/// Passes the present content of the table with the index `index` to the machine; an empty table if
/// it is damaged or erased.
void LineProtocol::select_kerf(std::uint32_t index) {
  kerf::SelectedTable selected{.count = static_cast<std::uint32_t>(kerf_.count()), .index = index};
  if (index < selected.count) {
    const auto table = kerf_.table(index);
    if (table.ok()) selected.view = table.value();
  }
  machine_.use_kerf(selected);
  kerf_seen_ = kerf_.revision();
}

}  // namespace cnc

#include "host-sim/knowledge/sqlite.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <exception>
#include <stdexcept>

namespace sim {
namespace {

[[noreturn]] void fail_in_sql(const std::string& file, sqlite3* connection) {
  throw std::runtime_error(fmt::format("{}: {}", file, sqlite3_errmsg(connection)));
}

int open_flags(SqlFile::Mode mode) {
  if (mode == SqlFile::Mode::kRead) return SQLITE_OPEN_READONLY;
  return SQLITE_OPEN_READWRITE | (mode == SqlFile::Mode::kCreate ? SQLITE_OPEN_CREATE : 0);
}

/// Returns whether a process left the file in the middle of a change, which only a connection with
/// write access can undo.
bool is_left_half_changed(sqlite3* connection) {
  constexpr const char* kLook = "SELECT count(*) FROM sqlite_master";
  return sqlite3_exec(connection, kLook, nullptr, nullptr, nullptr) != SQLITE_OK &&
         (sqlite3_extended_errcode(connection) == SQLITE_READONLY_ROLLBACK ||
          sqlite3_extended_errcode(connection) == SQLITE_READONLY_RECOVERY);
}

}  // namespace

void SqlStatement::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SqlStatement::SqlStatement(const std::string& file, sqlite3* connection, std::string_view sql)
    : file_{file}, connection_{connection} {
  sqlite3_stmt* statement = nullptr;
  const int size = static_cast<int>(sql.size());
  if (sqlite3_prepare_v2(connection, sql.data(), size, &statement, nullptr) != SQLITE_OK) {
    fail_in_sql(file_, connection_);
  }
  statement_.reset(statement);
}

void SqlStatement::check(int code) const {
  if (code != SQLITE_OK) fail_in_sql(file_, connection_);
}

SqlStatement& SqlStatement::bind(std::string_view text) {
  const int size = static_cast<int>(text.size());
  check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), size, SQLITE_TRANSIENT));
  return *this;
}

SqlStatement& SqlStatement::bind(double value) {
  check(sqlite3_bind_double(statement_.get(), ++bound_, value));
  return *this;
}

SqlStatement& SqlStatement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
  return *this;
}

SqlStatement& SqlStatement::bind_null() {
  check(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

bool SqlStatement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) fail_in_sql(file_, connection_);
  return code == SQLITE_ROW;
}

std::string SqlStatement::text(int column) const {
  const unsigned char* const letters = sqlite3_column_text(statement_.get(), column);
  return letters == nullptr ? "" : reinterpret_cast<const char*>(letters);
}

double SqlStatement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

bool SqlStatement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t SqlStatement::whole(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

void SqlFile::Closer::operator()(sqlite3* connection) const { sqlite3_close(connection); }

SqlFile::SqlFile(std::string file, Mode mode) : file_{std::move(file)} {
  open(open_flags(mode));
  if (mode == Mode::kRead && is_left_half_changed(connection_.get())) open(SQLITE_OPEN_READWRITE);
  run("PRAGMA foreign_keys = ON");
}

void SqlFile::open(int flags) {
  constexpr int kPatienceMs = 5000;  // Greatest time to wait for another command that writes, ms.
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(file_.c_str(), &connection, flags, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) fail_in_sql(file_, connection);
  sqlite3_busy_timeout(connection, kPatienceMs);
}

void SqlFile::run(const char* sql) const {
  if (sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail_in_sql(file_, connection_.get());
  }
}

std::int64_t SqlFile::last_row() const { return sqlite3_last_insert_rowid(connection_.get()); }

SqlTransaction::~SqlTransaction() {
  if (!open_) return;
  try {
    file_.run("ROLLBACK");
  } catch (const std::exception&) {
    // The exception that ended the transaction is reported. SQLite undoes the rest when the file is
    // closed.
  }
}

}  // namespace sim

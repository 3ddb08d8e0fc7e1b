#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace sim {

/// One statement of SQL while it runs. Failures throw std::runtime_error naming the file.
class SqlStatement {
 public:
  /// Binds a value to the next parameter; the first call binds the first parameter.
  SqlStatement& bind(std::string_view text);
  SqlStatement& bind(double value);
  SqlStatement& bind(std::int64_t value);
  SqlStatement& bind(std::size_t value) { return bind(static_cast<std::int64_t>(value)); }
  SqlStatement& bind(std::uint32_t value) { return bind(static_cast<std::int64_t>(value)); }

  SqlStatement& bind_null();
  /// Binds the value, or NULL if the value is empty.
  template <typename Value>
  SqlStatement& bind_optional(const std::optional<Value>& value) {
    return value ? bind(*value) : bind_null();
  }

  /// Reads the next row. Returns whether there is one. Its columns are numbered from 0.
  [[nodiscard]] bool next();
  /// Runs a statement without rows.
  void run() { static_cast<void>(next()); }

  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::int64_t whole(int column) const;
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::uint32_t small(int column) const {
    return static_cast<std::uint32_t>(whole(column));
  }

 private:
  friend class SqlFile;
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };

  SqlStatement(const std::string& file, sqlite3* connection, std::string_view sql);
  void check(int code) const;

  std::string file_;
  sqlite3* connection_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
  int bound_ = 0;
};

/// An SQLite data base. Failures throw std::runtime_error naming the file.
class SqlFile {
 public:
  enum class Mode { kRead, kWrite, kCreate };

  /// Opens the file. A data base `:memory:` exists as long as the object. With kRead nothing is
  /// changed, with one exception: a file that a process left in the middle of a change is restored
  /// to its state before the change.
  SqlFile(std::string file, Mode mode);

  [[nodiscard]] const std::string& name() const { return file_; }
  [[nodiscard]] SqlStatement prepare(std::string_view sql) const {
    return {file_, connection_.get(), sql};
  }
  /// Runs several statements without parameters or rows.
  void run(const char* sql) const;
  [[nodiscard]] std::int64_t last_row() const;

 private:
  struct Closer {
    void operator()(sqlite3* connection) const;
  };

  void open(int flags);

  std::string file_;
  std::unique_ptr<sqlite3, Closer> connection_;
};

/// A transaction: all statements since its begin are undone unless commit() was called.
class SqlTransaction {
 public:
  explicit SqlTransaction(const SqlFile& file) : file_{file} { file_.run("BEGIN IMMEDIATE"); }
  ~SqlTransaction();
  SqlTransaction(const SqlTransaction&) = delete;
  SqlTransaction& operator=(const SqlTransaction&) = delete;

  void commit() {
    file_.run("COMMIT");
    open_ = false;
  }

 private:
  const SqlFile& file_;
  bool open_ = true;
};

}  // namespace sim

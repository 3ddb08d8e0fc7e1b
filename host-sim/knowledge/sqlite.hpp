#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace sim {

/// One statement of SQL being run. Failures throw std::runtime_error naming the file.
class SqlStatement {
 public:
  /// Binds the next parameter, from the first on.
  SqlStatement& bind(std::string_view text);
  SqlStatement& bind(double value);
  SqlStatement& bind(std::int64_t value);
  SqlStatement& bind(std::size_t value) { return bind(static_cast<std::int64_t>(value)); }
  SqlStatement& bind(std::uint32_t value) { return bind(static_cast<std::int64_t>(value)); }

  SqlStatement& bind_null();
  /// Binds the value, or NULL where there is none.
  template <typename Value>
  SqlStatement& bind_optional(const std::optional<Value>& value) {
    return value ? bind(*value) : bind_null();
  }

  /// True while there is a row; its columns count from 0.
  [[nodiscard]] bool next();
  /// For statements without rows.
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

/// A data base of SQLite. Failures throw std::runtime_error naming the file.
class SqlFile {
 public:
  enum class Mode { kRead, kWrite, kCreate };

  /// `:memory:` lives as long as the object. kRead changes nothing, but a file that a process left
  /// in the middle of a change, which is brought back to its state before that.
  SqlFile(std::string file, Mode mode);

  [[nodiscard]] const std::string& name() const { return file_; }
  [[nodiscard]] SqlStatement prepare(std::string_view sql) const {
    return {file_, connection_.get(), sql};
  }
  /// Several statements without parameters or rows.
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

/// All of it or nothing: what was done since is undone unless commit() was called.
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

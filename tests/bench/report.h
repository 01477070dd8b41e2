#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/base/status.h"

namespace burnish {

/// Formats a number by a format of printf.
std::string in_words(const char* format, double value);

/// Rows under named columns. They are printed at once, and kept for JSON and for gnuplot.
class BenchTable {
 public:
  struct Column {
    std::string name;             ///< unit last: "solve_ms"
    const char* format = "%.3g";  ///< of printf, for a double
    int width = 0;                ///< at least the name's length
  };
  using Value = std::variant<std::string, double>;

  BenchTable(std::string name, std::vector<Column> columns);

  /// Adds one value per column. Prints the header if another table was printed last.
  void add(std::vector<Value> row);

  const std::string& name() const { return name_; }
  nlohmann::ordered_json to_json() const;  ///< an object per row
  std::string to_tab_separated() const;    ///< the header, then a line per row, full precision

 private:
  void print(size_t column, const std::string& text) const;

  std::string name_;
  std::vector<Column> columns_;
  std::vector<std::vector<Value>> rows_;
};

/// The results of one program of tests/bench.
class BenchReport {
 public:
  explicit BenchReport(std::string name) : name_(std::move(name)) {}

  /// The reference stays valid.
  BenchTable& add_table(std::string name, std::vector<BenchTable::Column> columns);

  /// Prints a line outside of tables, and keeps it.
  void remark(const std::string& line);

  /// Facts about the run that are not rows.
  nlohmann::ordered_json& facts() { return facts_; }
  const nlohmann::ordered_json& facts() const { return facts_; }

  /// Writes FOLDER/NAME.json, and FOLDER/TABLE.tsv for every table. Fails: as writing does.
  Status write(const std::filesystem::path& folder) const;

 private:
  std::string name_;
  nlohmann::ordered_json facts_;
  std::deque<BenchTable> tables_;
  std::vector<std::string> remarks_;
};

}  // namespace burnish

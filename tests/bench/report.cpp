#include "tests/bench/report.h"

#include <cstdio>

#include "common/base/atomic_file.h"

namespace burnish {

namespace {

using nlohmann::ordered_json;

const BenchTable* printed_last = nullptr;  // another table prints its header again

std::string formatted(const BenchTable::Value& value, const char* format) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return in_words(format, std::get<double>(value));
}

}  // namespace

std::string in_words(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

BenchTable::BenchTable(std::string name, std::vector<Column> columns)
    : name_(std::move(name)), columns_(std::move(columns)) {
  for (Column& column : columns_)
    column.width = std::max(column.width, static_cast<int>(column.name.size()));
}

void BenchTable::print(size_t column, const std::string& text) const {
  const bool last = column + 1 == columns_.size();
  std::printf("%*s%s", columns_[column].width, text.c_str(), last ? "\n" : "  ");
}

void BenchTable::add(std::vector<Value> row) {
  BURNISH_CHECK(row.size() == columns_.size(), "a value per column of " + name_);
  if (printed_last != this) {
    printed_last = this;
    std::printf("\n%s\n", name_.c_str());
    for (size_t c = 0; c < columns_.size(); ++c) print(c, columns_[c].name);
  }
  for (size_t c = 0; c < columns_.size(); ++c) print(c, formatted(row[c], columns_[c].format));
  std::fflush(stdout);
  rows_.push_back(std::move(row));
}

ordered_json BenchTable::to_json() const {
  ordered_json rows = ordered_json::array();
  for (const auto& row : rows_) {
    ordered_json& object = rows.emplace_back(ordered_json::object());
    for (size_t c = 0; c < columns_.size(); ++c)
      std::visit([&](const auto& value) { object[columns_[c].name] = value; }, row[c]);
  }
  return rows;
}

std::string BenchTable::to_tab_separated() const {
  std::string text;
  const auto add = [&](size_t c, const std::string& field) {
    text += field;
    text += c + 1 == columns_.size() ? '\n' : '\t';
  };
  for (size_t c = 0; c < columns_.size(); ++c) add(c, columns_[c].name);
  for (const auto& row : rows_)
    for (size_t c = 0; c < columns_.size(); ++c) add(c, formatted(row[c], "%.9g"));
  return text;
}

BenchTable& BenchReport::add_table(std::string name, std::vector<BenchTable::Column> columns) {
  return tables_.emplace_back(std::move(name), std::move(columns));
}

void BenchReport::remark(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  remarks_.push_back(line);
}

Status BenchReport::write(const std::filesystem::path& folder) const {
  ordered_json all = facts_;
  for (const BenchTable& table : tables_) {
    all["tables"][table.name()] = table.to_json();
    RETURN_IF_ERROR(write_file(folder / (table.name() + ".tsv"), table.to_tab_separated()));
  }
  all["remarks"] = remarks_;
  return write_file(folder / (name_ + ".json"), all.dump(2) + "\n");
}

}  // namespace burnish

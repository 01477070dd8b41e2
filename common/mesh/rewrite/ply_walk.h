#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"

namespace burnish {

/// A number in the body of a PLY file.
struct PlyValue {
  std::string_view bytes;  ///< inside the file's
  double number = 0;
};

/// Reads the elements in the body of a PLY file that was read before, one by one. `Source` reads
/// the values.
template <typename Source>
class PlyWalk {
 public:
  PlyWalk(Source source, const std::string& name) : source_(std::move(source)), name_(name) {}

  /// Reads an element. Keeps the values of one list if it is given. Fails: data_loss.
  Status read(const PlyElement& element, uint64_t number, size_t kept_list = kPlyNoList) {
    values_.resize(element.properties.size());
    list_.clear();
    for (size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (!(property.is_list() ? read_list(property, p == kept_list) : read_value(property, p)))
        return changed_original(
            name_, element.name + " " + std::to_string(number) + ": " + source_.failure());
    }
    if (source_.at_line_end()) return Status::ok();
    return changed_original(name_, element.name + " " + std::to_string(number) + " is longer");
  }

  /// One per property of the element; those of lists mean nothing.
  std::span<const PlyValue> values() const { return values_; }
  std::span<const double> list() const { return list_; }
  const Source& source() const { return source_; }

 private:
  bool read_value(const PlyProperty& property, size_t p) {
    if (!source_.read(property.type, values_[p].number)) return false;
    values_[p].bytes = source_.last_bytes();
    return true;
  }

  bool read_list(const PlyProperty& property, bool is_kept) {
    double count;
    if (!source_.read(*property.count_type, count) || !(count >= 0)) return false;
    if (!is_kept) return source_.skip(property.type, static_cast<uint64_t>(count));
    for (double i = 0, value; i < count; ++i) {
      if (!source_.read(property.type, value)) return false;
      list_.push_back(value);
    }
    return true;
  }

  Source source_;
  const std::string& name_;
  std::vector<PlyValue> values_;
  std::vector<double> list_;
};

}  // namespace burnish

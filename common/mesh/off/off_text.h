#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/mesh/reading/text_scanner.h"

namespace burnish {

/// The attributes that an OFF file's vertices have after x y z: normals, colours, then texture
/// coordinates.
struct OffKind {
  bool has_normals = false;
  bool has_colours = false;
  bool has_texture_coordinates = false;
};

/// Takes the first word of a file, OFF with any of ST, C and N before it, from the beginning of
/// `text`.
inline std::optional<OffKind> take_off_kind(std::string_view& text) {
  const auto take = [](std::string_view& rest, std::string_view word) {
    const bool is_there = rest.starts_with(word);
    if (is_there) rest.remove_prefix(word.size());
    return is_there;
  };
  std::string_view rest = text;
  OffKind kind;
  kind.has_texture_coordinates = take(rest, "ST");
  kind.has_colours = take(rest, "C");
  kind.has_normals = take(rest, "N");
  if (!take(rest, "OFF")) return std::nullopt;
  text = rest;
  return kind;
}

/// The words of an OFF file: Geomview's format and its variants with colours (C), normals (N) and
/// texture coordinates (ST).
///
/// Most files give each vertex and each face a line, and some put further numbers at its end. The
/// format goes by words, so an element may take several lines, and plain ones may share a line. The
/// number of lines tells which of these a file does.
class OffText {
 public:
  OffText(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps = {})
      : scanner_(bytes, name, {.hash_comments = true}, 0, steps) {}

  /// Reads the first word and the counts. Fails: invalid_argument that names what is wrong.
  Status read_header();

  const OffKind& kind() const { return kind_; }
  uint64_t vertices() const { return vertices_; }
  uint64_t faces() const { return faces_; }

  /// Goes to the next vertex or face. Returns false at the end of the file.
  bool next_element();

  /// Returns the element's next word; empty at its end.
  std::string_view next_word();

  /// The place in the file. It reads what follows an element on its line.
  TextScanner& scanner() { return scanner_; }
  const TextScanner& scanner() const { return scanner_; }

 private:
  enum class Lines { kOneEach, kSeveralEach, kShared };

  Status read_magic(std::string_view& counts);
  Status read_counts(std::string_view counts);
  Status parse_count(const std::string& what, std::string_view token, uint64_t limit,
                     uint64_t& count) const;
  Status check_size() const;
  void skip_edges();
  Lines count_lines() const;

  TextScanner scanner_;
  OffKind kind_;
  uint64_t vertices_ = 0;
  uint64_t faces_ = 0;
  Lines lines_ = Lines::kOneEach;
};

}  // namespace burnish

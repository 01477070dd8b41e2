#include "common/mesh/ply/ply_header.h"

#include <algorithm>
#include <utility>

#include "common/base/limits.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

namespace {

constexpr size_t kPropertiesMax = 1024;  // of all elements together

template <typename Named>
const Named* find_named(const std::vector<Named>& items, std::string_view name) {
  const auto item =
      std::find_if(items.begin(), items.end(), [&](const Named& i) { return i.name == name; });
  return item == items.end() ? nullptr : &*item;
}

class HeaderParser {
 public:
  HeaderParser(std::span<const uint8_t> bytes, const std::string& name)
      : scanner_(bytes, name), bytes_(bytes) {}

  Result<PlyHeader> parse() {
    const std::string_view magic = scanner_.next_line() ? scanner_.next_token() : "";
    const bool ends_in_cr = last_byte() == '\r';
    if (magic != "ply")
      return scanner_.error("not a PLY file: begins with " + in_quotes(magic) + ", not 'ply'");
    while (scanner_.next_line()) {
      if (scanner_.line_rest().size() > kLineBytesMax)
        return scanner_.error("the header line has " + std::to_string(scanner_.line_rest().size()) +
                              " bytes, the limit is " + std::to_string(kLineBytesMax));
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "end_header") return finish(ends_in_cr);
      RETURN_IF_ERROR(parse_line(keyword));
    }
    return scanner_.error("the header has no 'end_header'");
  }

 private:
  size_t offset() const { return bytes_.size() - scanner_.bytes_after_line(); }
  uint8_t last_byte() const { return offset() == 0 ? 0 : bytes_[offset() - 1]; }

  /// If lines end in CR, an LF behind the last one is the body's first byte.
  Result<PlyHeader> finish(bool ends_in_cr) {
    if (!has_format_) return scanner_.error("the header has no 'format' line");
    header_.body_offset = offset();
    if (ends_in_cr && last_byte() == '\n') --header_.body_offset;
    header_.lines = scanner_.line_number();
    return std::move(header_);
  }

  Status parse_line(std::string_view keyword) {
    if (keyword == "comment" || keyword == "obj_info") return Status::ok();
    if (keyword == "format") return parse_format();
    if (keyword == "element") return parse_element();
    if (keyword == "property") return parse_property();
    return scanner_.error("unknown header keyword " + in_quotes(keyword) +
                          "; is 'end_header' missing?");
  }

  Status parse_format() {
    const std::string_view encoding = scanner_.next_token();
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      return scanner_.error("unknown format " + in_quotes(encoding) +
                            "; use ascii, binary_little_endian or binary_big_endian");
    }
    const std::string_view version = scanner_.next_token();
    if (version != "1.0")
      return scanner_.error("PLY version " + in_quotes(version) + " is not supported; use 1.0");
    has_format_ = true;
    return Status::ok();
  }

  Status parse_element() {
    PlyElement element;
    element.name = scanner_.next_token();
    const std::string_view token = scanner_.next_token();
    int64_t count;
    if (!parse_integer(token, count) || count < 0)
      return scanner_.error("element " + in_quotes(element.name) + " has the count " +
                            in_quotes(token) + ", which is not an integer of 0 or more");
    element.count = static_cast<uint64_t>(count);
    if (header_.find(element.name) != nullptr)
      return scanner_.error("element " + in_quotes(element.name) + " is declared twice");
    if (element.name == "vertex") RETURN_IF_ERROR(check_limit(element, kVerticesMax));
    if (element.name == "face") RETURN_IF_ERROR(check_limit(element, kTrianglesMax));
    header_.elements.push_back(std::move(element));
    return check_declarations();
  }

  Status check_limit(const PlyElement& element, uint64_t limit) const {
    if (element.count <= limit) return Status::ok();
    return scanner_.error("element " + in_quotes(element.name) + " has the count " +
                          std::to_string(element.count) + ", the limit is " +
                          std::to_string(limit));
  }

  Status parse_property() {
    if (header_.elements.empty()) return scanner_.error("a property comes before any element");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    std::string_view type = scanner_.next_token();
    if (type == "list") {
      PlyType count_type = PlyType::kUint8;
      RETURN_IF_ERROR(parse_type(scanner_.next_token(), count_type));
      if (!is_integer(count_type)) return scanner_.error("a list's count must be an integer");
      property.count_type = count_type;
      type = scanner_.next_token();
    }
    RETURN_IF_ERROR(parse_type(type, property.type));
    property.name = scanner_.next_token();
    if (property.name.empty()) return scanner_.error("a property has no name");
    if (element.find(property.name) != nullptr)
      return scanner_.error("property " + in_quotes(property.name) + " of element " +
                            in_quotes(element.name) + " is declared twice");
    element.properties.push_back(std::move(property));
    return check_declarations();
  }

  Status parse_type(std::string_view token, PlyType& type) const {
    const std::optional<PlyType> known = ply_type_of_name(token);
    if (!known)
      return scanner_.error("unknown property type " + in_quotes(token) +
                            "; use char to double or int8 to float64");
    type = *known;
    return Status::ok();
  }

  /// Limits the number of declarations: the search for duplicates takes quadratic time.
  Status check_declarations() {
    if (++declarations_ <= kPropertiesMax) return Status::ok();
    return scanner_.error("the header declares more than " + std::to_string(kPropertiesMax) +
                          " elements and properties");
  }

  TextScanner scanner_;
  std::span<const uint8_t> bytes_;
  PlyHeader header_;
  bool has_format_ = false;
  size_t declarations_ = 0;
};

/// Returns the least bytes of one element in the body; in text a digit and a blank per property.
size_t bytes_min(const PlyElement& element, PlyEncoding encoding) {
  size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes +=
        encoding == PlyEncoding::kAscii ? 2 : bytes_of(property.count_type.value_or(property.type));
  return bytes;
}

Status check_counts(const PlyHeader& header, size_t file_bytes, const std::string& name) {
  size_t left = file_bytes - header.body_offset;
  if (header.encoding == PlyEncoding::kAscii) ++left;  // the last line may lack its end
  for (const PlyElement& element : header.elements) {
    const size_t each = bytes_min(element, header.encoding);
    if (each == 0) continue;
    if (element.count > left / each)
      return invalid_argument(name + ": the header promises " + std::to_string(element.count) +
                              " of element " + in_quotes(element.name) + ", at least " +
                              std::to_string(each) + " bytes each, but " + std::to_string(left) +
                              " of the file's " + std::to_string(file_bytes) +
                              " bytes are left for them; " + element.name + " " +
                              std::to_string(left / each) + " is not complete");
    left -= element.count * each;
  }
  return Status::ok();
}

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property_name) const {
  return find_named(properties, property_name);
}

const PlyElement* PlyHeader::find(std::string_view element_name) const {
  return find_named(elements, element_name);
}

Result<PlyHeader> parse_ply_header(std::span<const uint8_t> bytes, const std::string& name) {
  ASSIGN_OR_RETURN(PlyHeader header, HeaderParser(bytes, name).parse());
  RETURN_IF_ERROR(check_counts(header, bytes.size(), name));
  return header;
}

}  // namespace burnish

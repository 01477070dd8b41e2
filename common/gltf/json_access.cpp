#include "common/gltf/json_access.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "common/base/limits.h"
#include "common/base/text.h"

namespace burnish {

namespace {

/// Counts values, members and depth, and keeps nothing.
class GltfJsonLimits final : public nlohmann::json_sax<GltfJson> {
 public:
  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool key(string_t&) override {
    if (++members_.back() <= kGltfMembersMax) return count();
    complaint_ =
        "the JSON has an object of more than " + std::to_string(kGltfMembersMax) + " members";
    return false;
  }
  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception&) override {
    complaint_ = "the JSON is wrong at byte " + std::to_string(position);
    return false;
  }

  const std::string& complaint() const { return complaint_; }

 private:
  bool count() {
    if (++values_ <= kGltfValuesMax) return true;
    complaint_ = "the JSON has more than " + std::to_string(kGltfValuesMax) + " values";
    return false;
  }
  bool enter() {
    members_.push_back(0);
    if (members_.size() <= kGltfDepthMax) return count();
    complaint_ = "the JSON nests deeper than " + std::to_string(kGltfDepthMax) + " levels";
    return false;
  }
  bool leave() {
    members_.pop_back();
    return true;
  }

  size_t values_ = 0;
  std::vector<size_t> members_;  // of each object or array that is open
  std::string complaint_;
};

/// Walks through a text, one step a byte: one string may be the whole file.
class HeardText {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  HeardText(const char* at, FileSteps& steps) : at_(at), steps_(&steps) {}

  reference operator*() const { return *at_; }
  HeardText& operator++() {
    steps_->take();
    ++at_;
    return *this;
  }
  bool operator==(const HeardText& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  FileSteps* steps_;
};

}  // namespace

Result<GltfJson> parse_gltf_json(std::string_view text, const FileSteps& steps) {
  FileSteps bytes = steps;
  const HeardText begin(text.data(), bytes), end(text.data() + text.size(), bytes);
  GltfJsonLimits limits;
  if (!GltfJson::sax_parse(begin, end, &limits)) return invalid_argument(limits.complaint());
  GltfJson json = GltfJson::parse(begin, end, nullptr, false);
  if (!json.is_object()) return invalid_argument("the JSON is not an object");
  return json;
}

const GltfJson* find_member(const GltfJson& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

const GltfJson* find_object(const GltfJson& object, std::initializer_list<const char*> path) {
  const GltfJson* place = &object;
  for (const char* name : path)
    if ((place = find_member(*place, name)) == nullptr) return nullptr;
  return place->is_object() ? place : nullptr;
}

Result<uint64_t> read_whole(const GltfJson& object, const char* name, const std::string& place,
                            std::optional<uint64_t> absent) {
  constexpr double kLargest = 9007199254740992;  // 2^53
  const GltfJson* member = find_member(object, name);
  if (member == nullptr && absent) return *absent;
  if (member == nullptr) return invalid_argument(place + " has no " + name);
  const double value = member->is_number() ? member->get<double>() : -1;
  if (value >= 0 && value <= kLargest && value == std::floor(value))
    return static_cast<uint64_t>(value);
  return invalid_argument(place + ": " + name + " is " + value_text(*member) +
                          ", not a whole number of at most 2^53");
}

Result<const GltfJson*> find_element(const GltfJson& json, const char* name, uint64_t index,
                                     const std::string& place) {
  const size_t count = count_elements(json, name);
  if (index >= count)
    return invalid_argument(place + " refers to element " + std::to_string(index) + " of " + name +
                            ", but there are " + std::to_string(count) + ", numbered from 0");
  const GltfJson& element = json.at(name)[index];
  if (element.is_object()) return &element;
  return invalid_argument("element " + std::to_string(index) + " of " + name +
                          " is not an object: " + value_text(element));
}

size_t count_elements(const GltfJson& json, const char* name) {
  const GltfJson* elements = find_member(json, name);
  return elements != nullptr && elements->is_array() ? elements->size() : 0;
}

std::string place_text(std::string_view kind, uint64_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

std::string value_text(const GltfJson& value) {
  constexpr size_t kBytes = 40;
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  return shortened(value.dump(), kBytes);
}

}  // namespace burnish

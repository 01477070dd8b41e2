#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// JSON that keeps the order of members.
using GltfJson = nlohmann::ordered_json;

/// Parses the JSON of a glTF file. Fails: invalid_argument if it is not an object, nests deeper
/// than kGltfDepthMax, has more than kGltfValuesMax values, or has an object of more than
/// kGltfMembersMax. `steps` hears of each byte.
Result<GltfJson> parse_gltf_json(std::string_view text, const FileSteps& steps = {});

/// Returns a member, or nullptr if `object` is not an object or does not have it.
const GltfJson* find_member(const GltfJson& object, const char* name);

/// Returns the object at `path`, such as {"extensions", "NAME"}; nullptr if there is none.
const GltfJson* find_object(const GltfJson& object, std::initializer_list<const char*> path);

/// Reads a member that is a whole number of at most 2^53. `place` begins the messages: "accessor
/// 3". Fails: invalid_argument for another value, or for none if `absent` is empty.
Result<uint64_t> read_whole(const GltfJson& object, const char* name, const std::string& place,
                            std::optional<uint64_t> absent = std::nullopt);

/// Returns element `index` of the document's array `name`. Fails: invalid_argument if it is not an
/// object that exists. `place` names who refers to it.
Result<const GltfJson*> find_element(const GltfJson& json, const char* name, uint64_t index,
                                     const std::string& place);

/// Returns how many elements the document's array `name` has; 0 if it is not there.
size_t count_elements(const GltfJson& json, const char* name);

/// "accessor 3".
std::string place_text(std::string_view kind, uint64_t index);

/// Returns a value for a message: at most 40 bytes of JSON.
std::string value_text(const GltfJson& value);

}  // namespace burnish

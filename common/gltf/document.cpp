#include "common/gltf/document.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/gltf/data_uri.h"
#include "common/gltf/reading_limit.h"

namespace burnish {

static constexpr std::string_view kReadExtensions[] = {
    kDracoExtension, kMeshoptExtensions[0], kMeshoptExtensions[1], "KHR_mesh_quantization"};

// These change how the surface looks, not where it is.
static constexpr std::string_view kAppearancePrefixes[] = {"KHR_materials_", "KHR_texture_",
                                                           "EXT_texture_", "KHR_lights_"};

static std::string_view text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

static Status check_required_extension(const GltfJson& required) {
  const std::string name = required.is_string() ? required.get<std::string>() : "";
  const auto is_prefix = [&](std::string_view prefix) { return name.starts_with(prefix); };
  if (std::ranges::find(kReadExtensions, name) != std::end(kReadExtensions) ||
      std::ranges::any_of(kAppearancePrefixes, is_prefix))
    return Status::ok();
  return invalid_argument("the file needs the extension " + value_text(required) +
                          ", which Burnish does not read");
}

static Status check_asset(const GltfJson& json) {
  const GltfJson* asset = find_object(json, {"asset"});
  const GltfJson* version = asset == nullptr ? nullptr : find_member(*asset, "version");
  if (version == nullptr || !version->is_string() || !version->get<std::string>().starts_with("2."))
    return invalid_argument("glTF version " +
                            (version == nullptr ? "(none)" : value_text(*version)) +
                            " cannot be read, only 2.0");
  const GltfJson* required = find_member(json, "extensionsRequired");
  if (required == nullptr || !required->is_array()) return Status::ok();
  for (const GltfJson& name : *required) RETURN_IF_ERROR(check_required_extension(name));
  return Status::ok();
}

std::string unescaped_uri(std::string_view uri) {
  const auto digit = [](char c) {
    const size_t value = std::string_view("0123456789abcdef").find(static_cast<char>(c | 0x20));
    return c >= '0' && c <= '9' ? c - '0' : value == std::string_view::npos ? -1 : int(value);
  };
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    text += is_escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return text;
}

static Status open_data_uri(std::string_view uri, const std::string& place, const FileSteps& steps,
                            GltfBuffer& buffer) {
  ASSIGN_OR_RETURN(buffer.decoded, read_data_uri(uri, place, steps));
  buffer.home = GltfBuffer::Home::kText;
  buffer.bytes = buffer.decoded;
  return Status::ok();
}

static Status open_uri(const std::string& uri, const GltfFilesBeside& beside,
                       const std::string& place, const FileSteps& steps, GltfBuffer& buffer) {
  if (is_data_uri(uri)) return open_data_uri(uri, place, steps, buffer);
  if (!beside)
    return invalid_argument(place + " is another file, '" + shortened(uri, kNameBytesMax) +
                            "'; pack both as a .zip archive, or save as .glb");
  buffer.home = GltfBuffer::Home::kBeside;
  buffer.path = unescaped_uri(uri);
  ASSIGN_OR_RETURN(buffer.bytes, beside(buffer.path));
  return Status::ok();
}

/// Opens a buffer and adds it. `files` are the paths of those before it.
static Status open_buffer(uint64_t index, const GltfFilesBeside& beside, const FileSteps& steps,
                          GltfDocument& document, std::set<std::string>& files) {
  const std::string place = place_text("buffer", index);
  ASSIGN_OR_RETURN(const GltfJson* json, find_element(document.json, "buffers", index, place));
  ASSIGN_OR_RETURN(const uint64_t length, read_whole(*json, "byteLength", place));
  GltfBuffer& buffer = document.buffers.emplace_back();
  const GltfJson* uri = find_member(*json, "uri");
  if (uri != nullptr && uri->is_string()) {
    RETURN_IF_ERROR(open_uri(uri->get_ref<const std::string&>(), beside, place, steps, buffer));
  } else if (index == 0 && document.parts.has_bin) {
    buffer.home = GltfBuffer::Home::kChunk;
    buffer.bytes = document.parts.bin;
  } else {
    return Status::ok();
  }
  if (!buffer.path.empty() && !files.insert(buffer.path).second)
    return invalid_argument(place + " is the same file as another, '" +
                            shortened(buffer.path, kNameBytesMax) + "'");
  if (!buffer.path.empty()) document.file_bytes += buffer.bytes.size();
  if (length > buffer.bytes.size())
    return invalid_argument(place + ": byteLength is " + std::to_string(length) +
                            ", but there are " + std::to_string(buffer.bytes.size()) + " bytes");
  buffer.bytes = buffer.bytes.first(length);
  return Status::ok();
}

Result<GltfJson> read_gltf_json(std::span<const uint8_t> bytes) {
  if (!is_glb(bytes)) return parse_gltf_json(text_of(bytes));
  ASSIGN_OR_RETURN(const GlbParts parts, split_glb(bytes));
  return parse_gltf_json(parts.json);
}

const GltfJson* find_meshopt(const GltfJson& view) {
  for (const char* name : kMeshoptExtensions)
    if (const GltfJson* packed = find_object(view, {"extensions", name})) return packed;
  return nullptr;
}

Result<GltfDocument> open_gltf(std::span<const uint8_t> bytes, const GltfFilesBeside& beside,
                               const FileSteps& steps) {
  GltfDocument document;
  document.is_binary = is_glb(bytes);
  document.file_bytes = bytes.size();
  std::string_view text = text_of(bytes);
  if (document.is_binary) {
    ASSIGN_OR_RETURN(document.parts, split_glb(bytes));
    text = document.parts.json;
  }
  ASSIGN_OR_RETURN(document.json, parse_gltf_json(text, steps));
  RETURN_IF_ERROR(check_asset(document.json));
  const size_t buffers = count_elements(document.json, "buffers");
  document.buffers.reserve(buffers);
  std::set<std::string> files;
  for (size_t i = 0; i < buffers; ++i)
    RETURN_IF_ERROR(open_buffer(i, beside, steps, document, files));
  document.reading_bytes_max = gltf_reading_bytes_max(document.json, document.file_bytes);
  return document;
}

}  // namespace burnish

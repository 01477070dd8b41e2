#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/gltf/base64.h"
#include "tests/common/mesh/reading.h"

namespace burnish {

using TestJson = nlohmann::ordered_json;

/// Returns a binary glTF file of a JSON text and a BIN chunk.
inline std::string glb_of(std::string json, std::string bin) {
  json.append((4 - json.size() % 4) % 4, ' ');
  bin.append((4 - bin.size() % 4) % 4, '\0');
  const auto word = [](size_t value) { return bytes_of(static_cast<uint32_t>(value)); };
  std::string chunks = word(json.size()) + "JSON" + json;
  if (!bin.empty()) chunks += word(bin.size()) + std::string("BIN\0", 4) + bin;
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

/// A glTF file that a test puts together: its JSON and its only buffer.
struct GlbFile {
  TestJson json = {{"asset", {{"version", "2.0"}, {"generator", "a test"}}},
                   {"scene", 0},
                   {"scenes", {{{"nodes", {0}}}}},
                   {"nodes", {{{"mesh", 0}}}}};
  TestJson more_buffers = TestJson::array();  // behind the one of `bin`
  std::string bin;

  size_t add_view(const std::string& bytes, const TestJson& more = TestJson::object()) {
    bin.append((4 - bin.size() % 4) % 4, '\0');
    TestJson view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    view.update(more);
    json["bufferViews"].push_back(view);
    bin += bytes;
    return json["bufferViews"].size() - 1;
  }

  size_t add_accessor(size_t view, const char* type, int component, size_t count,
                      const TestJson& more = TestJson::object()) {
    TestJson accessor = {
        {"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
    accessor.update(more);
    json["accessors"].push_back(accessor);
    return json["accessors"].size() - 1;
  }

  size_t add_floats(const char* type, size_t count, const std::vector<float>& numbers) {
    std::string bytes;
    for (const float number : numbers) bytes += bytes_of(number);
    return add_accessor(add_view(bytes), type, 5126, count);
  }

  size_t add_indices(const std::vector<uint16_t>& corners) {
    std::string bytes;
    for (const uint16_t corner : corners) bytes += bytes_of(corner);
    return add_accessor(add_view(bytes), "SCALAR", 5123, corners.size());
  }

  /// Adds a primitive to a mesh.
  TestJson& add_primitive(const TestJson& attributes, size_t mesh = 0) {
    while (json["meshes"].size() <= mesh)
      json["meshes"].push_back({{"primitives", TestJson::array()}});
    TestJson& primitives = json["meshes"][mesh]["primitives"];
    primitives.push_back({{"attributes", attributes}});
    return primitives.back();
  }

  std::string glb() const {
    TestJson all = json;
    if (!bin.empty()) all["buffers"] = {{{"byteLength", bin.size()}}};
    for (const TestJson& buffer : more_buffers) all["buffers"].push_back(buffer);
    return glb_of(all.dump(), bin);
  }

  std::string gltf(int indent = -1) const {
    TestJson all = json;
    const std::span bytes(reinterpret_cast<const uint8_t*>(bin.data()), bin.size());
    all["buffers"] = {{{"byteLength", bin.size()},
                       {"uri", "data:application/octet-stream;base64," + to_base64(bytes)}}};
    return all.dump(indent);
  }
};

inline const std::vector<float> kSquareFloats = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

/// Two triangles over four positions, as Blender's exporter orders its members.
inline GlbFile square_glb() {
  GlbFile file;
  file.json["asset"]["generator"] = "Khronos glTF Blender I/O v4.2.57";
  file.json["nodes"][0]["name"] = "Scan";
  const size_t positions = file.add_floats("VEC3", 4, kSquareFloats);
  file.json["accessors"][positions]["min"] = {0, 0, 0};
  file.json["accessors"][positions]["max"] = {1, 1, 0};
  file.add_primitive({{"POSITION", positions}})["indices"] = file.add_indices({0, 1, 2, 0, 2, 3});
  return file;
}

}  // namespace burnish

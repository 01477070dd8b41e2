#include <algorithm>

#include "common/mesh/output_buffer.h"
#include "common/mesh/ply/ply.h"

namespace burnish {

static bool has_transparency(const MeshView& mesh) {
  return std::any_of(mesh.colours.begin(), mesh.colours.end(),
                     [](const Rgba8& colour) { return colour[3] != 255; });
}

static std::string header_of(const MeshView& mesh, size_t channels) {
  const std::string type = mesh.has_double_positions ? "double" : "float";
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  header += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) header += "property " + type + " " + axis + "\n";
  constexpr const char* kChannels[] = {"red", "green", "blue", "alpha"};
  for (size_t i = 0; i < channels; ++i)
    header += std::string("property uchar ") + kChannels[i] + "\n";
  header += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  return header + "property list uchar int vertex_indices\nend_header\n";
}

Status write_ply(const MeshView& mesh, OutputBuffer& output) {
  const size_t channels = !mesh.has_colours() ? 0 : has_transparency(mesh) ? 4 : 3;
  output.put_text(header_of(mesh, channels));
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.has_double_positions) {
      output.put_bytes(mesh.vertices[v]);
    } else {
      const Vec3f position = mesh.vertices[v].cast<float>();
      output.put_bytes(position);
    }
    for (size_t i = 0; i < channels; ++i) output.put_bytes(mesh.colours[v][i]);
  }
  for (const Triangle& triangle : mesh.triangles) {
    output.put_bytes(uint8_t{3});
    output.put_bytes(triangle);
  }
  return output.flush();
}

}  // namespace burnish

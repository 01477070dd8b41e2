#include "common/mesh/obj/obj.h"
#include "common/mesh/output_buffer.h"

namespace burnish {

static void put_vertex(const MeshView& mesh, size_t v, OutputBuffer& output) {
  output.put_text("v");
  for (const double x : mesh.vertices[v]) {
    output.put_text(" ");
    if (mesh.has_double_positions) {
      output.put_number(x);
    } else {
      output.put_number(static_cast<float>(x));
    }
  }
  for (size_t channel = 0; mesh.has_colours() && channel < 3; ++channel) {
    output.put_text(" ");
    output.put_number(static_cast<float>(mesh.colours[v][channel]) / 255);
  }
  output.put_text("\n");
}

/// Writes colours as fractions after the position, as most programs do. OBJ has no place for alpha.
Status write_obj(const MeshView& mesh, OutputBuffer& output) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) put_vertex(mesh, v, output);
  for (const Triangle& triangle : mesh.triangles) {
    output.put_text("f");
    for (const uint32_t v : triangle) {
      output.put_text(" ");
      output.put_number(uint64_t{v} + 1);
    }
    output.put_text("\n");
  }
  return output.flush();
}

}  // namespace burnish

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/mesh/rewrite/rewrite.h"
#include "tests/common/mesh/reading.h"

namespace burnish {

/// Moves vertex number `v` of a mesh.
using Move = std::function<Vec3d(size_t v, const Vec3d& position)>;

inline Vec3d stay(size_t, const Vec3d& position) {
  return position;
}

/// Reads a file, edits the mesh, and returns the file written again. Returns the refusal's message
/// if rewriting fails.
inline std::string edited(MeshFormat format, const std::string& content,
                          const std::function<void(TriangleMesh&)>& edit) {
  TriangleMesh after = parsed(format, content);
  const std::vector<Vec3d> before = after.vertices;
  edit(after);
  std::string text;
  OutputBuffer output([&](std::string_view piece) {
    text += piece;
    return Status::ok();
  });
  const Status status =
      rewrite_mesh({reinterpret_cast<const uint8_t*>(content.data()), content.size()}, format,
                   "scan", {before, after}, output);
  return status.is_ok() ? text : status.message();
}

/// Does the same with moved vertices.
inline std::string rewritten(MeshFormat format, const std::string& content,
                             const Move& move = stay) {
  return edited(format, content, [&](TriangleMesh& mesh) {
    for (size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertices[v] = move(v, mesh.vertices[v]);
  });
}

/// Does the same with another colour of a vertex.
inline std::string recoloured(MeshFormat format, const std::string& content, size_t vertex,
                              const Rgba8& colour) {
  return edited(format, content, [&](TriangleMesh& mesh) { mesh.colours.at(vertex) = colour; });
}

/// Returns the text with one part replaced by another. Fails the test unless it is there once.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const size_t place = text.find(part);
  EXPECT_NE(place, std::string::npos) << part;
  EXPECT_EQ(text.find(part, place + 1), std::string::npos) << part;
  return place == std::string::npos ? text : text.replace(place, part.size(), by);
}

}  // namespace burnish

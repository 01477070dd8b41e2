#pragma once

#include <algorithm>
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
                          const std::function<void(TriangleMesh&)>& edit, double cap = 0) {
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
                   "scan", {before, after, cap}, output);
  return status.is_ok() ? text : status.message();
}

/// Does the same with moved vertices.
inline std::string rewritten(MeshFormat format, const std::string& content, const Move& move = stay,
                             double cap = 0) {
  const auto edit = [&](TriangleMesh& mesh) {
    for (size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertices[v] = move(v, mesh.vertices[v]);
  };
  return edited(format, content, edit, cap);
}

/// Returns the largest move of a vertex between two files.
inline double largest_move(MeshFormat format, const std::string& before, const std::string& after) {
  const TriangleMesh from = parsed(format, before), to = parsed(format, after);
  EXPECT_EQ(from.vertices.size(), to.vertices.size());
  double largest = 0;
  for (size_t v = 0; v < from.vertices.size(); ++v)
    largest = std::max(largest, (to.vertices[v] - from.vertices[v]).norm());
  return largest;
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

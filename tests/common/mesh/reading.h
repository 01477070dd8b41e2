#pragma once

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/io/mesh_io.h"

namespace burnish {

inline Result<TriangleMesh> parse(MeshFormat format, const std::string& content) {
  return read_mesh({reinterpret_cast<const uint8_t*>(content.data()), content.size()}, format,
                   "scan");
}

/// Returns the mesh, or an empty mesh and a failed test.
inline TriangleMesh parsed(MeshFormat format, const std::string& content) {
  Result<TriangleMesh> mesh = parse(format, content);
  EXPECT_TRUE(mesh.is_ok()) << mesh.status().message();
  return mesh.is_ok() ? std::move(mesh).value() : TriangleMesh();
}

/// Returns why the content is refused. Returns "" and fails the test if it is not refused as a bad
/// file.
inline std::string refusal(MeshFormat format, const std::string& content) {
  const Result<TriangleMesh> mesh = parse(format, content);
  EXPECT_EQ(mesh.status().code(), StatusCode::kInvalidArgument);
  return mesh.status().message();
}

/// Returns the bytes of the values in memory, little-endian.
template <typename... Values>
std::string bytes_of(const Values&... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}

/// Returns a text with the line ends of old Macs, which some programs still write.
inline std::string with_cr(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

inline std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/atomic_file.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

/// Inside this folder: one reader and one writer per format, which mesh_io.cpp chooses from.
///
/// Readers take a whole file's bytes and its name for the messages, and leave validate() to their
/// caller. Polygons become fans around their first corner; faces that repeat a vertex are kept;
/// faces of fewer than three corners are refused. Every count is checked against the bytes that
/// are left before memory is taken for it, and what polygons unfold to against the file's size, so
/// that memory stays below kReadingBytesPerFileByte times the file.
/// Elements are numbered from 0 in messages, lines and bytes as editors do (from 1 and from 0).
namespace burnish {

Result<TriangleMesh> read_ply(std::span<const uint8_t> bytes, const std::string& name);
Result<TriangleMesh> read_obj(std::span<const uint8_t> bytes, const std::string& name);
Result<TriangleMesh> read_stl(std::span<const uint8_t> bytes, const std::string& name);
Result<TriangleMesh> read_off(std::span<const uint8_t> bytes, const std::string& name);

/// Writers append to `file` and leave its commit to their caller. Needs: a valid mesh.
Status write_ply(const TriangleMesh& mesh, AtomicFile& file);
Status write_obj(const TriangleMesh& mesh, AtomicFile& file);
Status write_stl(const TriangleMesh& mesh, AtomicFile& file);

}  // namespace burnish

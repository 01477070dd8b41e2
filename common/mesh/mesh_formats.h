#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/stored_mesh.h"
#include "common/mesh/triangle_mesh.h"

/// Private to this folder: one reader and one writer per format; mesh_io.cpp chooses among them.
///
/// A reader takes a whole file's bytes and its name for messages; the caller calls validate().
/// Polygons become fans around their first corner; faces that repeat a vertex are kept; faces of
/// fewer than three corners give no triangle. A vertex that no triangle uses may have coordinates
/// that are none (OddVertices). Before memory is taken, every count is checked against the
/// bytes that are left, and the triangles of polygons against the file's size. So memory stays
/// below kReadingBytesPerFileByte times the file. Messages number elements and bytes from 0 and
/// lines from 1. `steps` hears of every element; WorkCancelled passes through a reader.
namespace burnish {

Result<TriangleMesh> read_ply(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
Result<TriangleMesh> read_obj(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
Result<TriangleMesh> read_stl(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
Result<TriangleMesh> read_off(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
Result<TriangleMesh> read_zip(std::span<const uint8_t> bytes, const std::string& name,
                              const FileBudget& budget);
/// Fill an empty mesh in scratch space.
Status read_ply(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);
Status read_obj(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);
Status read_stl(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);
Status read_off(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);

Result<uint64_t> predict_zip_reading_bytes(std::span<const uint8_t> bytes, const std::string& name);

/// Write everything to `output`. Needs: a valid mesh. Throw: WorkCancelled.
Status write_ply(const MeshView& mesh, OutputBuffer& output);
Status write_obj(const MeshView& mesh, OutputBuffer& output);
Status write_stl(const MeshView& mesh, OutputBuffer& output);
Status write_glb(const MeshView& mesh, OutputBuffer& output);

}  // namespace burnish

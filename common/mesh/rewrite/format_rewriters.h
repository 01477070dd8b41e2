#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"

/// Private to this folder: one rewriter per format; rewrite.cpp chooses among them. A rewriter
/// copies the original's bytes and replaces numbers. It keeps the bytes of a number that stays the
/// same in the precision that it is written in. Fails: data_loss if the original is not the file
/// that was read. Throws: WorkCancelled, as the output's budget says.
namespace burnish {

Status rewrite_ply(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output);
Status rewrite_obj(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output);
/// Returns colour_scale() of the vertices' colours; nothing if they have none.
std::optional<float> obj_colour_scale(std::span<const uint8_t> bytes, const FileSteps& steps);
Status rewrite_stl(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output);
Status rewrite_off(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output);
Status rewrite_zip(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output, PictureWork* pictures);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"
#include "common/mesh/rewrite/byte_patch.h"
#include "common/mesh/rewrite/moved_mesh.h"
#include "common/mesh/rewrite/moved_normals.h"
#include "common/mesh/text_scanner.h"

namespace burnish {

/// A text that is read and copied at once.
struct TextPatch {
  TextScanner scanner;
  BytePatch patch;
};

/// Replaces the next three numbers of the line by a vertex's position. Fails: data_loss if they are
/// not its position before.
Status replace_position(const std::string& name, const MovedMesh& moved, uint64_t vertex,
                        TextPatch& text);

/// Replaces those of the next three numbers of the line that do not read as this colour. Leaves
/// other texts alone. `scale`: colour_scale() of the file.
void replace_colour(const Rgba8& colour, float scale, TextPatch& text);

/// Turns the normal that the next three numbers of the line are. Leaves other texts alone.
void replace_normal(const AreaVectors& areas, TextPatch& text);

}  // namespace burnish

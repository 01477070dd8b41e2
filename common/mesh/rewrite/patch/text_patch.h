#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/base/status.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/moved/moved_normals.h"
#include "common/mesh/rewrite/patch/byte_patch.h"
#include "common/mesh/rewrite/patch/written_mesh.h"

namespace burnish {

/// A text that is read and copied at once.
struct TextPatch {
  TextScanner scanner;
  BytePatch patch;
};

/// Replaces three words by a vertex's position. Fails: data_loss if they are not its position
/// before.
Status replace_position(const std::string& name, const WrittenMesh& written, uint64_t vertex,
                        const PositionWords& words, BytePatch& patch);

/// Replaces those of three numbers that do not read as this colour. Leaves other texts alone.
/// `scale`: colour_scale() of the file.
void replace_colour(const Rgba8& colour, float scale, const PositionWords& words, BytePatch& patch);

/// Turns the normal that three numbers are. Leaves other texts alone.
void replace_normal(const AreaVectors& areas, const WrittenNumber& number,
                    const PositionWords& words, BytePatch& patch);

/// Adds three numbers to a text's digits.
void add_words(const PositionWords& words, TextDigits& digits);

/// Returns three numbers as floats; nothing unless all are numbers.
std::optional<Vec3f> parse_normal(const PositionWords& words);

}  // namespace burnish

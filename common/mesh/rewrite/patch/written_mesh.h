#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/ply/ply_type.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/patch/text_digits.h"

namespace burnish {

/// How a file keeps a coordinate: as a value of a type; in a text as the shortest decimal number of
/// a type, or in the digits of the file.
struct WrittenNumber {
  PlyType type = PlyType::kFloat64;
  bool is_text = false;
  std::optional<TextDigits> digits;

  /// A coordinate of a text. `digits` are those of all its coordinates. Takes more decimals where
  /// these are coarser than an export's accuracy, kTextStepShare of the mesh's diagonal.
  static WrittenNumber of_text(const MovedMesh& moved, TextDigits digits);

  /// A coordinate of a normal in a text. `digits` are those of all its normals.
  static WrittenNumber of_normals(TextDigits digits);

  /// Returns the number that the file has for `value` in the place of `before`.
  double kept(double value, double before) const;

  /// Returns whether the file has another number for `value` than it has for `before`.
  bool tells_apart(double value, double before) const;

  /// Returns the next such number from `kept` towards `before`, and `before` if none lies between.
  double nearer(double kept, double before) const;

  /// Returns the text of a number that the file keeps, in the form of the old text.
  std::string text_of(double kept, double before, std::string_view old) const;
};

/// The largest step of a text's coordinates, as a share of the mesh's diagonal. Exports agree with
/// the reference within 5e-7 of it, and rounding to half a step takes less than a fifth of that.
inline constexpr double kTextStepShare = 1e-7;

/// The largest step of a text's normals: an angle that nobody sees.
inline constexpr double kNormalStep = 1e-4;

/// A moved mesh at the positions that a file has afterwards. A coordinate that the file cannot tell
/// from the one before is the one before. No vertex is farther from its place than the cap.
class WrittenMesh {
 public:
  /// Takes 24 bytes a vertex. Needs: `moved` outlives it.
  WrittenMesh(const MovedMesh& moved, std::array<WrittenNumber, 3> axes);
  WrittenMesh(const MovedMesh& moved, const WrittenNumber& each)
      : WrittenMesh(moved, {each, each, each}) {}
  WrittenMesh(const WrittenMesh&) = delete;
  WrittenMesh& operator=(const WrittenMesh&) = delete;

  const MovedMesh& moved() const { return written_; }
  const WrittenNumber& axis(size_t number) const { return axes_[number]; }

 private:
  Vec3d position(const Vec3d& before, const Vec3d& after) const;

  std::array<WrittenNumber, 3> axes_;
  std::vector<Vec3d> vertices_;
  MovedMesh written_;
};

}  // namespace burnish

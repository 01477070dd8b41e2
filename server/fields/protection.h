#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/edit/edit.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The cells in which nothing moves, as a series of edits chose them. The same edits in the same
/// order choose the same cells.
class Protection {
 public:
  /// Needs: prepared outlives this.
  explicit Protection(const PreparedMesh& prepared) : prepared_(prepared) {}

  void apply(const Protect& change);
  /// Needs: a change of kProtection whose cells are active.
  void apply(const SetCellFields& change);
  void clear() { is_protected_.clear(); }

  /// Returns whether no change has been applied since clear().
  bool is_empty() const { return is_protected_.empty(); }
  bool has(size_t cell) const { return !is_protected_.empty() && is_protected_[cell] != 0; }
  /// Returns the cells, rising.
  std::vector<int32_t> cells() const;

 private:
  void grow(int cells);
  std::vector<uint8_t> chosen(const LassoRegion& lasso) const;
  std::vector<uint8_t> chosen(const CurvatureRegion& region) const;
  std::vector<uint8_t> chosen(const PieceRegion& region) const;

  const PreparedMesh& prepared_;
  std::vector<uint8_t> is_protected_;  // per cell; empty: none
};

}  // namespace burnish

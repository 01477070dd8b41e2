#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "common/mesh/rewrite/gltf/gltf_columns.h"
#include "common/mesh/rewrite/gltf/gltf_edit.h"

namespace burnish {

/// Private to this folder. Puts columns into a document's accessors.
class GltfAccessors {
 public:
  /// Needs: the columns outlive it.
  GltfAccessors(const GltfColumns& columns, GltfEdit& edit);

  /// Writes the changed columns: into the accessor's own bytes if they are its alone and floats,
  /// else into a new view. Accessors of which two nodes want different values get copies.
  void put_columns();

  /// Returns the accessor that has the values of a column.
  uint64_t accessor_of(size_t column) const { return accessor_of_[column]; }

  /// Writes unpacked elements to a new view of the accessor. Does it once. Returns the accessor,
  /// which is new if `accessor` is not in the document.
  uint64_t put_unpacked(const GltfAccessor& accessor, bool is_vertex);

 private:
  using Users = std::vector<size_t>;  // columns of one accessor

  void put_users(uint64_t accessor, const Users& users);
  void put_floats(uint64_t accessor, const GltfColumn& column);
  void patch(const GltfColumn& column);
  bool can_patch(const GltfColumn& column) const;

  const GltfColumns& columns_;
  GltfEdit& edit_;
  std::vector<bool> is_shared_;
  std::vector<uint64_t> accessor_of_;  // by column
  std::set<uint64_t> put_;             // accessors with new views
};

}  // namespace burnish

#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "server/fields/alphas.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// A second, plain implementation of the session model. It answers every question from the list of
/// all edits, from the beginning, cell by cell. It shares no code with server/session.
class SerialReplay {
 public:
  struct Item {
    uint64_t number;
    std::string author;
    Edit edit;
    bool on;
  };

  /// Applies all edits or none. Returns false if one of them cannot be done.
  bool apply(const std::vector<AuthoredEdit>& edits);

  const std::vector<AuthoredEdit>& edits() const { return edits_; }

  /// Returns the items after the first `count` edits.
  std::vector<Item> items(size_t count) const;
  std::vector<Item> items() const { return items(edits_.size()); }

  struct Cells {
    CellAlphas alphas;
    std::vector<float> beta;
  };
  static Cells cells(const std::vector<Item>& items, const PreparedMesh& prepared);

 private:
  std::vector<AuthoredEdit> edits_;
};

}  // namespace burnish

#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "server/fields/alphas.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The session model once more, as plainly as it can be said: every question is answered from the
/// list of all edits, from the beginning, cell by cell. Shares no code with server/session.
class SerialReplay {
 public:
  struct Item {
    uint64_t number;
    std::string author;
    Edit edit;
    bool on;
  };

  /// All or none; false when one of them cannot be done.
  bool apply(const std::vector<AuthoredEdit>& edits);

  const std::vector<AuthoredEdit>& edits() const { return edits_; }

  /// What the first `count` edits amount to.
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

#include "tests/server/live/serial_replay.h"

#include "common/grid/morton.h"

namespace burnish {
namespace {

/// The list while it is read.
struct Reading {
  std::vector<SerialReplay::Item> items;
  std::map<std::string, std::vector<uint64_t>> undone;
  std::map<std::string, std::vector<SerialReplay::Item>> checkpoints;  // the items at that time
  bool possible = true;

  SerialReplay::Item* item(uint64_t number) {
    for (auto& candidate : items)
      if (candidate.number == number) return &candidate;
    return nullptr;
  }

  void undo(const std::string& author) {
    for (size_t i = items.size(); i-- > 0;) {
      if (items[i].author != author || !items[i].on) continue;
      if (std::holds_alternative<SetCheckpoint>(items[i].edit.change)) continue;
      items[i].on = false;
      undone[author].push_back(items[i].number);
      return;
    }
    possible = false;
  }

  void redo(const std::string& author) {
    std::vector<uint64_t> left = undone[author];
    while (!left.empty()) {
      SerialReplay::Item* last = item(left.back());
      left.pop_back();
      if (last->on) continue;
      last->on = true;
      undone[author] = left;
      return;
    }
    possible = false;
  }

  void switch_entry(const SwitchEntry& change) {
    SerialReplay::Item* found = item(change.entry);
    if (!found || std::holds_alternative<SetCheckpoint>(found->edit.change)) {
      possible = false;
    } else {
      found->on = change.enabled;
    }
  }

  void restore(const std::string& name) {
    if (!checkpoints.contains(name)) {
      possible = false;
      return;
    }
    for (auto& now : items) {
      if (std::holds_alternative<SetCheckpoint>(now.edit.change)) continue;
      now.on = false;
      for (const auto& then : checkpoints[name])
        if (then.number == now.number) now.on = then.on;
    }
  }

  void take(uint64_t number, const AuthoredEdit& edit) {
    const auto& change = edit.edit.change;
    if (std::holds_alternative<Undo>(change)) return undo(edit.author);
    if (std::holds_alternative<Redo>(change)) return redo(edit.author);
    if (const auto* one = std::get_if<SwitchEntry>(&change)) return switch_entry(*one);
    if (const auto* named = std::get_if<RestoreCheckpoint>(&change)) return restore(named->name);
    items.push_back({number, edit.author, edit.edit, true});
    if (const auto* named = std::get_if<SetCheckpoint>(&change)) {
      checkpoints[named->name] = items;
    } else {
      undone[edit.author].clear();
    }
  }
};

Reading read(const std::vector<AuthoredEdit>& edits, size_t count) {
  Reading reading;
  for (size_t i = 0; i < count; ++i) reading.take(i + 1, edits[i]);
  return reading;
}

struct Cell {
  double alpha1 = 50, alpha2 = 50;
  float paint = 0, weight = 0;
};

void paint(Cell& cell, const Vec3d& middle, const Stroke& stroke) {
  double beta = cell.paint, covered = cell.weight;
  for (const Vec3d& centre : dab_centres(stroke)) {
    const double w =
        stroke.brush.strength *
        fall_off_weight(stroke.brush.fall_off, (middle - centre).norm() / stroke.brush.radius);
    if (w == 0) continue;
    const double rest = covered * (1 - w);
    covered = rest + w;
    beta = (beta * rest + stroke.brush.beta * w) / covered;
  }
  cell.paint = static_cast<float>(beta);
  cell.weight = static_cast<float>(covered);
}

}  // namespace

bool SerialReplay::apply(const std::vector<AuthoredEdit>& edits) {
  std::vector<AuthoredEdit> longer = edits_;
  longer.insert(longer.end(), edits.begin(), edits.end());
  if (!read(longer, longer.size()).possible) return false;
  edits_ = std::move(longer);
  return true;
}

std::vector<SerialReplay::Item> SerialReplay::items(size_t count) const {
  return read(edits_, count).items;
}

SerialReplay::Cells SerialReplay::cells(const std::vector<Item>& items,
                                        const PreparedMesh& prepared) {
  Cells result;
  for (size_t c = 0; c < prepared.cells.size(); ++c) {
    const Vec3i place = morton_point(prepared.cells[c]);
    const Vec3d middle = prepared.frame.to_file(place.cast<double>() + Vec3d::Constant(0.5));
    Cell cell;
    double slider = 1;
    const SetCellFields::Cell* own = nullptr;
    for (const Item& item : items) {
      if (!item.on) continue;
      const auto& change = item.edit.change;
      if (const auto* set = std::get_if<SetGradientScale>(&change)) slider = set->beta;
      if (const auto* stroke = std::get_if<Stroke>(&change)) paint(cell, middle, *stroke);
      if (const auto* set = std::get_if<SetTransferCurve>(&change)) {
        cell.alpha1 = set->curve.alpha(prepared.curvature[c].kappa1);
        cell.alpha2 = set->curve.alpha(prepared.curvature[c].kappa2);
      }
      if (const auto* set = std::get_if<SetCellFields>(&change))
        for (const auto& candidate : set->cells)
          if (candidate.cell == place) own = &candidate;
    }
    const double w = cell.weight;
    result.alphas.alpha1.push_back(static_cast<float>(own ? own->alpha1 : cell.alpha1));
    result.alphas.alpha2.push_back(static_cast<float>(own ? own->alpha2 : cell.alpha2));
    result.beta.push_back(static_cast<float>(own ? own->beta : (1 - w) * slider + w * cell.paint));
  }
  return result;
}

}  // namespace burnish

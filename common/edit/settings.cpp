#include "common/edit/settings.h"

namespace burnish {
namespace {

struct Taker {
  Settings& settings;

  void operator()(const SetGradientScale& change) const { settings.beta = change.beta; }
  void operator()(const SetTransferCurve& change) const { settings.curve = change.curve; }
  void operator()(const SetControls& change) const { settings.controls = change.controls; }
  void operator()(const SetEqualiser& change) const { settings.equaliser = change.equaliser; }
  void operator()(const SetPalette& change) const { settings.palette = change.palette; }
  void operator()(const SetColour& change) const { settings.colour = change.filter; }
  void operator()(const SetEdges& change) const { settings.edges = change.filter; }
  // Places of the surface, and which edits count.
  void operator()(const Stroke&) const {}
  void operator()(const SetCellFields&) const {}
  void operator()(const Protect&) const {}
  void operator()(const Undo&) const {}
  void operator()(const Redo&) const {}
  void operator()(const SwitchEntry&) const {}
  void operator()(const SetCheckpoint&) const {}
  void operator()(const RestoreCheckpoint&) const {}
  void operator()(const Damaged&) const {}
};

}  // namespace

void Settings::take(const Change& change) {
  std::visit(Taker{*this}, change);
}

void Settings::take(const PreviewChange& change) {
  std::visit(Taker{*this}, change);
}

}  // namespace burnish

#pragma once

#include "common/edit/edit.h"

namespace burnish {

/// The values that the last edit of each kind sets for a whole session.
struct Settings {
  double beta = kBetaDefault;  ///< of cells that are not painted
  TransferCurve curve{kAlphaDefault};
  Controls controls;
  Equaliser equaliser;
  Palette palette;
  ColourFilter colour;
  EdgeFilter edges;
  bool operator==(const Settings&) const = default;

  /// Takes what the change sets. Other kinds set nothing here.
  void take(const Change& change);
  void take(const PreviewChange& change);
};

}  // namespace burnish

#pragma once

#include <utility>

#include "common/edit/settings.h"
#include "common/wire/bands_wire.h"
#include "common/wire/edit_wire.h"

namespace burnish {

/// Writes the settings into a message that has their fields: SessionState or HistoryChanged.
template <typename Message>
void write_settings(const Settings& settings, Message& message) {
  message.set_gradient_scale(settings.beta);
  *message.mutable_transfer_curve() = to_wire(settings.curve);
  *message.mutable_controls() = to_wire(settings.controls);
  *message.mutable_equaliser() = to_wire(settings.equaliser);
  *message.mutable_palette() = to_wire(settings.palette);
  *message.mutable_colour() = to_wire(settings.colour);
  if (settings.edges != EdgeFilter()) *message.mutable_edges() = to_wire(settings.edges);
}

/// Fails: as TransferCurve::create().
template <typename Message>
Result<Settings> read_settings(const Message& message) {
  ASSIGN_OR_RETURN(TransferCurve curve, from_wire(message.transfer_curve()));
  ASSIGN_OR_RETURN(Palette palette, from_wire(message.palette()));
  ASSIGN_OR_RETURN(const EdgeFilter edges, from_wire(message.edges()));
  return Settings{message.gradient_scale(),
                  std::move(curve),
                  from_wire(message.controls()),
                  from_wire(message.equaliser()),
                  std::move(palette),
                  from_wire(message.colour(), message.has_colour()),
                  message.has_edges() ? edges : EdgeFilter()};
}

}  // namespace burnish

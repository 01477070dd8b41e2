#include "client/cli/controls_options.h"

#include "client/cli/in_range.h"
#include "common/base/limits.h"

namespace burnish {

Controls ControlsOptions::over(Controls now) const {
  return {pin_rims.value_or(now.pin_rims), cap.value_or(now.cap),
          keep_volume.value_or(now.keep_volume)};
}

void add_controls_options(CLI::App& command, ControlsOptions& options) {
  const std::map<std::string, bool> words = {{"on", true}, {"off", false}};
  command
      .add_option("--pin-rims", options.pin_rims,
                  "Keep the rims of an open scan where they are: on (as it begins) or off")
      ->transform(CLI::CheckedTransformer(words))
      ->type_name("on|off");
  command
      .add_option("--cap", options.cap,
                  "Move nothing more than this, in the scan's units; 0: no cap")
      ->check(in_range(0.0, kCoordinateMagnitudeMax));
  command
      .add_option("--keep-volume", options.keep_volume,
                  "Keep the volume of a closed scan: on or off (as it begins)")
      ->transform(CLI::CheckedTransformer(words))
      ->type_name("on|off");
}

}  // namespace burnish

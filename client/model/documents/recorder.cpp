#include "client/model/documents/recorder.h"

#include "common/base/line_text.h"
#include "common/edit/edit_lines.h"

namespace burnish {

void Recorder::record(const std::string& line) {
  if (sink_) sink_(line);
}

void Recorder::record(const Edit& edit) {
  const std::string line = line_of(edit.change);
  if (!line.empty()) record(line);
}

void Recorder::record(const Camera& camera) {
  record("up " + std::string(name_of(camera.up)));
  record(std::string("orthographic ") + (camera.orthographic ? "on" : "off"));
  LineText line(LineText::kExact);
  line << "camera " << camera.azimuth_degrees << ' ' << camera.elevation_degrees << ' '
       << camera.distance << ' ' << camera.target.x() << ' ' << camera.target.y() << ' '
       << camera.target.z();
  record(line.text());
}

}  // namespace burnish

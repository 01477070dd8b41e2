#include "client/model/recorder.h"

#include "common/base/line_text.h"
#include "common/edit/protect_words.h"

namespace burnish {

void Recorder::record(const std::string& line) {
  if (sink_) sink_(line);
}

namespace {

const char* fall_off_name(FallOff fall_off) {
  static const char* const kNames[] = {"smooth", "linear", "sharp", "constant"};
  return kNames[static_cast<int>(fall_off)];
}

struct LineOf {
  LineText& line;

  void operator()(const SetGradientScale& change) const { line << "beta " << change.beta; }
  void operator()(const SetTransferCurve& change) const {
    line << "curve " << change.curve.to_string();
  }
  void operator()(const Stroke& stroke) const {
    line << "stroke " << stroke.brush.radius << ' ' << stroke.brush.strength << ' '
         << stroke.brush.beta << ' ' << fall_off_name(stroke.brush.fall_off)
         << brush_words(stroke.brush);
    for (const Vec3d& point : stroke.path)
      line << ' ' << point.x() << ' ' << point.y() << ' ' << point.z();
  }
  void operator()(const SetCellFields&) const {}
  void operator()(const SetControls& change) const {
    const Controls& controls = change.controls;
    line << "controls " << (controls.pin_rims ? "on " : "off ") << controls.cap
         << (controls.keep_volume ? " on" : " off");
  }
  void operator()(const Protect& change) const { line << "protect " << to_words(change); }
  void operator()(const SetEqualiser& change) const {
    line << "bands";
    for (const Band& band : change.equaliser.bands) line << ' ' << band.size << ':' << band.gain;
  }
  void operator()(const SetPalette& change) const { line << "palette " << to_line(change.palette); }
  void operator()(const SetColour& change) const {
    line << "colours " << change.filter.beta << ' ' << change.filter.alpha;
  }
  void operator()(const SetEdges& change) const {
    const EdgeFilter& edges = change.filter;
    line << "edges " << name_of(edges.kind) << ' ' << edges.strength << ' ' << edges.edge_angle
         << ' ' << edges.passes << ' ' << edges.crispness;
  }
  void operator()(const Undo&) const { line << "undo"; }
  void operator()(const Redo&) const { line << "redo"; }
  void operator()(const SwitchEntry& change) const {
    line << "switch " << change.entry << (change.enabled ? " on" : " off");
  }
  void operator()(const SetCheckpoint& change) const { line << "checkpoint " << change.name; }
  void operator()(const RestoreCheckpoint& change) const { line << "restore " << change.name; }
  void operator()(const Damaged&) const {}
};

}  // namespace

void Recorder::record(const Edit& edit) {
  LineText line(LineText::kExact);
  std::visit(LineOf{line}, edit.change);
  if (!line.text().empty()) record(line.text());
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

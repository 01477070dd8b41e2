#include "common/wire/edit_wire.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/service/scan_info.h"
#include "common/wire/edit_bytes.h"
#include "common/wire/format_wire.h"
#include "common/wire/protect_wire.h"

namespace burnish {
namespace {

v1::FallOff fall_off_to_wire(FallOff fall_off) {
  switch (fall_off) {
    case FallOff::kSmooth:
      return v1::FALL_OFF_SMOOTH;
    case FallOff::kLinear:
      return v1::FALL_OFF_LINEAR;
    case FallOff::kSharp:
      return v1::FALL_OFF_SHARP;
    case FallOff::kConstant:
      return v1::FALL_OFF_CONSTANT;
  }
  return v1::FALL_OFF_UNSPECIFIED;
}

Result<FallOff> fall_off_from_wire(v1::FallOff fall_off) {
  switch (fall_off) {
    case v1::FALL_OFF_SMOOTH:
      return FallOff::kSmooth;
    case v1::FALL_OFF_LINEAR:
      return FallOff::kLinear;
    case v1::FALL_OFF_SHARP:
      return FallOff::kSharp;
    case v1::FALL_OFF_CONSTANT:
      return FallOff::kConstant;
    default:
      break;
  }
  return invalid_argument("brush fall-off " + std::to_string(static_cast<int>(fall_off)) +
                          " is none of 1 (smooth), 2 (linear), 3 (sharp), 4 (constant)");
}

/// Keeps numbers beyond any limit beyond it: validate() refuses them.
int number_of(uint32_t number) {
  return static_cast<int>(std::min<uint32_t>(number, std::numeric_limits<int>::max()));
}

Result<Stroke> stroke_from_wire(const v1::Stroke& message) {
  Stroke stroke;
  read_fields(message.brush(), stroke.brush);
  ASSIGN_OR_RETURN(stroke.brush.fall_off, fall_off_from_wire(message.brush().fall_off()));
  stroke.brush.band = number_of(message.brush().band());
  stroke.brush.curve = number_of(message.brush().curve());
  stroke.brush.colour = message.brush().colour();
  stroke.brush.edges = message.brush().edges();
  stroke.brush.texture = message.brush().texture();
  for (const v1::Point& point : message.path()) stroke.path.push_back(from_wire(point));
  return stroke;
}

/// Reads a kind that gestures show, from an Edit or a Preview; leaves `change` alone for others.
template <typename Message>
Status read_shown(const Message& message, std::optional<Change>& change) {
  if (message.has_gradient_scale()) change = SetGradientScale{message.gradient_scale().beta()};
  if (message.has_transfer_curve()) {
    ASSIGN_OR_RETURN(TransferCurve curve, from_wire(message.transfer_curve()));
    change = SetTransferCurve{std::move(curve)};
  }
  if (message.has_stroke()) {
    ASSIGN_OR_RETURN(change, stroke_from_wire(message.stroke()));
  }
  if (message.has_equaliser()) change = SetEqualiser{from_wire(message.equaliser())};
  if (message.has_palette()) {
    ASSIGN_OR_RETURN(Palette palette, from_wire(message.palette()));
    change = SetPalette{std::move(palette)};
  }
  if (message.has_colour()) change = SetColour{from_wire(message.colour(), true)};
  if (message.has_edges()) {
    ASSIGN_OR_RETURN(const EdgeFilter filter, from_wire(message.edges()));
    change = SetEdges{filter};
  }
  if (message.has_texture()) change = SetTexture{from_wire(message.texture(), true)};
  return Status::ok();
}

/// Reads the kinds that no gesture shows.
Status read_unshown(const v1::Edit& message, std::optional<Change>& change) {
  if (message.has_cell_fields()) {
    SetCellFields cells;
    RETURN_IF_ERROR(append_cells(message.cell_fields(), cells));
    change = std::move(cells);
  }
  if (message.has_controls()) change = SetControls{from_wire(message.controls())};
  if (message.has_protect()) {
    ASSIGN_OR_RETURN(change, from_wire(message.protect()));
  }
  if (message.has_undo()) change = Undo{};
  if (message.has_redo()) change = Redo{};
  if (message.has_switch_entry())
    change = SwitchEntry{message.switch_entry().entry(), message.switch_entry().enabled()};
  if (message.has_set_checkpoint()) change = SetCheckpoint{message.set_checkpoint().name()};
  if (message.has_restore_checkpoint())
    change = RestoreCheckpoint{message.restore_checkpoint().name()};
  return Status::ok();
}

/// Returns the edit if its id and its values are right; else names it.
Result<Edit> checked(const std::string& id, Status read, std::optional<Change> change) {
  RETURN_IF_ERROR(check_edit_id(id));
  const auto named = [&](const Status& status) { return status.with_context("edit " + id); };
  if (read.is_ok() && !change) read = invalid_argument("it changes nothing that this server knows");
  if (!read.is_ok()) return named(read);
  Edit edit{id, *std::move(change)};
  const Status valid = validate(edit);
  if (!valid.is_ok()) return named(valid);
  return edit;
}

/// Sets the member of the oneof of a message that can have the change: Edit or Preview.
template <typename Message>
struct ChangeWriter {
  Message& message;

  void operator()(const SetGradientScale& change) const {
    message.mutable_gradient_scale()->set_beta(change.beta);
  }
  void operator()(const SetTransferCurve& change) const {
    *message.mutable_transfer_curve() = to_wire(change.curve);
  }
  void operator()(const Stroke& stroke) const { *message.mutable_stroke() = to_wire(stroke); }
  void operator()(const SetCellFields& change) const {
    *message.mutable_cell_fields() = to_wire(change, 0, change.cells.size());
  }
  void operator()(const SetControls& change) const {
    *message.mutable_controls() = to_wire(change.controls);
  }
  void operator()(const Protect& change) const { *message.mutable_protect() = to_wire(change); }
  void operator()(const SetEqualiser& change) const {
    *message.mutable_equaliser() = to_wire(change.equaliser);
  }
  void operator()(const SetPalette& change) const {
    *message.mutable_palette() = to_wire(change.palette);
  }
  void operator()(const SetColour& change) const {
    *message.mutable_colour() = to_wire(change.filter);
  }
  void operator()(const SetEdges& change) const {
    *message.mutable_edges() = to_wire(change.filter);
  }
  void operator()(const SetTexture& change) const {
    *message.mutable_texture() = to_wire(change.filter);
  }
  void operator()(const Undo&) const { message.mutable_undo(); }
  void operator()(const Redo&) const { message.mutable_redo(); }
  void operator()(const SwitchEntry& change) const {
    message.mutable_switch_entry()->set_entry(change.entry);
    message.mutable_switch_entry()->set_enabled(change.enabled);
  }
  void operator()(const SetCheckpoint& change) const {
    message.mutable_set_checkpoint()->set_name(change.name);
  }
  void operator()(const RestoreCheckpoint& change) const {
    message.mutable_restore_checkpoint()->set_name(change.name);
  }
  void operator()(const Damaged&) const {}  // no message carries one
};

// A message that has the fields of settings: SessionState or HistoryChanged.
template <typename Message>
void write_all(const Settings& settings, Message& message) {
  message.set_gradient_scale(settings.beta);
  *message.mutable_transfer_curve() = to_wire(settings.curve);
  *message.mutable_controls() = to_wire(settings.controls);
  *message.mutable_equaliser() = to_wire(settings.equaliser);
  *message.mutable_palette() = to_wire(settings.palette);
  *message.mutable_colour() = to_wire(settings.colour);
  if (settings.edges != EdgeFilter()) *message.mutable_edges() = to_wire(settings.edges);
  if (settings.texture.is_on()) *message.mutable_texture() = to_wire(settings.texture);
}

template <typename Message>
Result<Settings> read_all(const Message& message) {
  ASSIGN_OR_RETURN(TransferCurve curve, from_wire(message.transfer_curve()));
  ASSIGN_OR_RETURN(Palette palette, from_wire(message.palette()));
  ASSIGN_OR_RETURN(const EdgeFilter edges, from_wire(message.edges()));
  return Settings{message.gradient_scale(),
                  std::move(curve),
                  from_wire(message.controls()),
                  from_wire(message.equaliser()),
                  std::move(palette),
                  from_wire(message.colour(), message.has_colour()),
                  message.has_edges() ? edges : EdgeFilter(),
                  from_wire(message.texture(), message.has_texture())};
}

}  // namespace

Status check_edit_id(const std::string& id) {
  const bool printable =
      std::all_of(id.begin(), id.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  if (!id.empty() && id.size() <= kEditIdBytesMax && printable) return Status::ok();
  return invalid_argument("an edit's id is 1 to " + std::to_string(kEditIdBytesMax) +
                          " printable ASCII characters; this one has " + std::to_string(id.size()) +
                          " bytes");
}

v1::Stroke to_wire(const Stroke& stroke) {
  v1::Stroke message;
  v1::Brush* brush = message.mutable_brush();
  write_fields(stroke.brush, *brush);
  brush->set_fall_off(fall_off_to_wire(stroke.brush.fall_off));
  if (stroke.brush.band > 0) brush->set_band(static_cast<uint32_t>(stroke.brush.band));
  if (stroke.brush.curve > 0) brush->set_curve(static_cast<uint32_t>(stroke.brush.curve));
  if (stroke.brush.colour) brush->set_colour(true);
  if (stroke.brush.edges) brush->set_edges(true);
  if (stroke.brush.texture) brush->set_texture(true);
  for (const Vec3d& point : stroke.path) *message.add_path() = to_wire(point);
  return message;
}

v1::SetTransferCurve to_wire(const TransferCurve& curve) {
  v1::SetTransferCurve message;
  for (const TransferCurve::Point& point : curve.points()) {
    v1::CurvePoint* entry = message.add_points();
    entry->set_kappa(point.kappa);
    entry->set_alpha(point.alpha);
  }
  return message;
}

Result<TransferCurve> from_wire(const v1::SetTransferCurve& message) {
  std::vector<TransferCurve::Point> points;
  for (const v1::CurvePoint& point : message.points())
    points.push_back({point.kappa(), point.alpha()});
  return TransferCurve::create(std::move(points));
}

v1::Controls to_wire(const Controls& controls) {
  v1::Controls message;
  write_fields(controls, message);
  return message;
}

Controls from_wire(const v1::Controls& message) {
  return {message.pin_rims(), message.cap(), message.keep_volume()};
}

v1::Equaliser to_wire(const Equaliser& equaliser) {
  v1::Equaliser message;
  for (const Band& band : equaliser.bands) write_fields(band, *message.add_bands());
  return message;
}

Equaliser from_wire(const v1::Equaliser& message) {
  Equaliser equaliser;
  for (const v1::Band& band : message.bands())
    equaliser.bands.push_back({band.size(), band.gain()});
  return equaliser;
}

v1::Palette to_wire(const Palette& palette) {
  v1::Palette message;
  for (const PaletteCurve& curve : palette.curves) {
    v1::PaletteCurve* sent = message.add_curves();
    sent->set_name(curve.name);
    sent->set_colour(curve.colour);
    *sent->mutable_curve() = to_wire(curve.curve);
  }
  return message;
}

Result<Palette> from_wire(const v1::Palette& message) {
  Palette palette;
  for (const v1::PaletteCurve& sent : message.curves()) {
    const std::string where = "curve " + std::to_string(palette.curves.size() + 1);
    auto curve = from_wire(sent.curve());
    if (!curve.is_ok()) return curve.status().with_context(where);
    palette.curves.push_back({sent.name(), sent.colour(), std::move(curve).value()});
  }
  return palette;
}

v1::ColourFilter to_wire(const ColourFilter& filter) {
  v1::ColourFilter message;
  write_fields(filter, message);
  return message;
}

ColourFilter from_wire(const v1::ColourFilter& message, bool is_there) {
  if (!is_there) return {};
  return {message.alpha(), message.beta()};
}

v1::TextureFilter to_wire(const TextureFilter& filter) {
  v1::TextureFilter message;
  write_fields(filter, message);
  return message;
}

TextureFilter from_wire(const v1::TextureFilter& message, bool is_there) {
  if (!is_there) return {};
  return {message.gain(), message.remove_light(), message.level_seams()};
}

v1::EdgeFilter to_wire(const EdgeFilter& filter) {
  v1::EdgeFilter message;
  message.set_strength(filter.strength);
  message.set_kind(filter.kind == NormalFilterKind::kEdges ? v1::NORMAL_FILTER_KIND_EDGES
                                                           : v1::NORMAL_FILTER_KIND_BILATERAL);
  message.set_edge_angle(filter.edge_angle);
  message.set_passes(static_cast<uint32_t>(filter.passes));
  message.set_crispness(filter.crispness);
  return message;
}

Result<EdgeFilter> from_wire(const v1::EdgeFilter& message) {
  if (message.kind() < v1::NORMAL_FILTER_KIND_UNSPECIFIED ||
      message.kind() > v1::NORMAL_FILTER_KIND_EDGES)
    return invalid_argument("filter of normals " + std::to_string(message.kind()) +
                            " is none of 1 (bilateral), 2 (edges)");
  constexpr uint32_t kNumbersMax = std::numeric_limits<int>::max();
  return EdgeFilter{message.strength(),
                    message.kind() == v1::NORMAL_FILTER_KIND_EDGES ? NormalFilterKind::kEdges
                                                                   : NormalFilterKind::kBilateral,
                    message.edge_angle(), static_cast<int>(std::min(message.passes(), kNumbersMax)),
                    message.crispness()};
}

v1::SetCellFields to_wire(const SetCellFields& change, size_t first, size_t count) {
  v1::SetCellFields message;
  if (change.target == CellTarget::kEdges) message.set_edges(true);
  if (change.target == CellTarget::kProtection) message.set_protection(true);
  if (change.target == CellTarget::kTexture) message.set_texture(true);
  for (size_t n = first; n < first + count; ++n) {
    const SetCellFields::Cell& cell = change.cells[n];
    v1::CellField* entry = message.add_cells();
    entry->set_i(cell.cell.x());
    entry->set_j(cell.cell.y());
    entry->set_k(cell.cell.z());
    entry->set_alpha1(cell.alpha1);
    entry->set_alpha2(cell.alpha2);
    entry->set_beta(cell.beta);
  }
  return message;
}

static CellTarget target_of(const v1::SetCellFields& message) {
  if (message.edges()) return CellTarget::kEdges;
  if (message.texture()) return CellTarget::kTexture;
  return message.protection() ? CellTarget::kProtection : CellTarget::kFields;
}

Status append_cells(const v1::SetCellFields& message, SetCellFields& change) {
  const size_t count = change.cells.size() + static_cast<size_t>(message.cells_size());
  if (count > kCellFieldsPerEditMax)
    return resource_exhausted("the edit sets " + std::to_string(count) + " cells, the limit is " +
                              std::to_string(kCellFieldsPerEditMax));
  const CellTarget target = target_of(message);
  if (!change.cells.empty() && change.target != target)
    return invalid_argument("the parts of an edit of cells set different things");
  change.target = target;
  for (const v1::CellField& entry : message.cells())
    change.cells.push_back(
        {Vec3i(entry.i(), entry.j(), entry.k()), entry.alpha1(), entry.alpha2(), entry.beta()});
  return Status::ok();
}

v1::Edit to_wire(const Edit& edit) {
  v1::Edit message;
  message.set_id(edit.id);
  std::visit(ChangeWriter<v1::Edit>{message}, edit.change);
  return message;
}

void write_preview(const PreviewChange& change, v1::Preview& message) {
  std::visit(ChangeWriter<v1::Preview>{message}, change);
}

void write_settings(const Settings& settings, v1::SessionState& message) {
  write_all(settings, message);
}

void write_settings(const Settings& settings, v1::HistoryChanged& message) {
  write_all(settings, message);
}

Result<Settings> read_settings(const v1::SessionState& message) {
  return read_all(message);
}

Result<Settings> read_settings(const v1::HistoryChanged& message) {
  return read_all(message);
}

Result<Edit> from_wire(const v1::Edit& message) {
  std::optional<Change> change;
  Status read = read_shown(message, change);
  if (read.is_ok() && !change) read = read_unshown(message, change);
  return checked(message.id(), std::move(read), std::move(change));
}

Result<Edit> from_wire(const v1::Preview& message) {
  std::optional<Change> change;
  Status read = read_shown(message, change);
  return checked(message.edit_id(), std::move(read), std::move(change));
}

template <typename Message>
static Result<std::vector<Edit>> read_edits(const Message& request) {
  const auto count = static_cast<size_t>(request.edits_size());
  if (count == 0 || count > kEditsPerFrameMax)
    return invalid_argument("a request has 1 to " + std::to_string(kEditsPerFrameMax) +
                            " edits, not " + std::to_string(count));
  std::vector<Edit> edits;
  for (const v1::Edit& message : request.edits()) {
    ASSIGN_OR_RETURN(Edit edit, from_wire(message));
    edits.push_back(std::move(edit));
  }
  return edits;
}

Result<std::vector<Edit>> edits_from_wire(const v1::ApplyEdits& message) {
  return read_edits(message);
}

Result<std::vector<Edit>> edits_from_wire(const v1::ApplyRequest& message) {
  return read_edits(message);
}

std::string edit_to_bytes(const Edit& edit) {
  return to_wire(edit).SerializeAsString();
}

Result<Edit> edit_from_bytes(std::string_view bytes) {
  v1::Edit message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return data_loss("the stored edit is damaged");
  return from_wire(message);
}

}  // namespace burnish

#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/edit/edit.h"

namespace burnish {

v1::Edit to_wire(const Edit& edit);

/// Fails: invalid_argument naming the edit's id, the value and its limit. Every value that can be
/// checked without the mesh is.
Result<Edit> from_wire(const v1::Edit& message);
/// Returns the edit that the gesture would be, so that the same values are refused.
Result<Edit> from_wire(const v1::Preview& message);

/// Reads 1 to kEditsPerFrameMax edits. Fails: invalid_argument as above, or naming their number.
Result<std::vector<Edit>> edits_from_wire(const v1::ApplyEdits& message);
Result<std::vector<Edit>> edits_from_wire(const v1::ApplyRequest& message);

/// Sets the member of the message that shows the change.
void write_preview(const PreviewChange& change, v1::Preview& message);

void write_settings(const Settings& settings, v1::SessionState& message);
void write_settings(const Settings& settings, v1::HistoryChanged& message);

/// Fails: as the values' from_wire() do.
Result<Settings> read_settings(const v1::SessionState& message);
Result<Settings> read_settings(const v1::HistoryChanged& message);

v1::Stroke to_wire(const Stroke& stroke);

v1::SetTransferCurve to_wire(const TransferCurve& curve);
Result<TransferCurve> from_wire(const v1::SetTransferCurve& message);

v1::Controls to_wire(const Controls& controls);
/// The range of the cap is checked with its edit.
Controls from_wire(const v1::Controls& message);

v1::Equaliser to_wire(const Equaliser& equaliser);
/// Values are checked with the edit: check_equaliser().
Equaliser from_wire(const v1::Equaliser& message);

v1::Palette to_wire(const Palette& palette);
/// Names and colours are checked with the edit: check_palette(). Fails: as TransferCurve::create().
Result<Palette> from_wire(const v1::Palette& message);

v1::ColourFilter to_wire(const ColourFilter& filter);
/// Returns what keeps the colours for a message that is absent. Values are checked with the edit.
ColourFilter from_wire(const v1::ColourFilter& message, bool is_there);

v1::TextureFilter to_wire(const TextureFilter& filter);
/// `is_there`: in the message around it.
TextureFilter from_wire(const v1::TextureFilter& message, bool is_there);

v1::EdgeFilter to_wire(const EdgeFilter& filter);
/// Fails: invalid_argument for an unknown kind of filter.
Result<EdgeFilter> from_wire(const v1::EdgeFilter& message);

/// Appends the cells of a message, or of a part of an upload, to `change`.
/// Fails: resource_exhausted above kCellFieldsPerEditMax; invalid_argument if they set different
/// things.
Status append_cells(const v1::SetCellFields& message, SetCellFields& change);

/// Cells first..first+count of a change, for an upload in parts.
v1::SetCellFields to_wire(const SetCellFields& change, size_t first, size_t count);

/// 1 to kEditIdBytesMax printable ASCII characters, else invalid_argument.
Status check_edit_id(const std::string& id);

}  // namespace burnish

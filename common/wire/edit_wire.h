#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/edit/edit.h"

namespace burnish {

v1::Edit to_wire(const Edit& edit);

/// Fails: invalid_argument naming the edit's id, the value and its limit. Every value that can be
/// checked without the mesh is.
Result<Edit> from_wire(const v1::Edit& message);

/// Reads 1 to kEditsPerFrameMax edits. Fails: invalid_argument as above, or naming their number.
Result<std::vector<Edit>> edits_from_wire(
    const google::protobuf::RepeatedPtrField<v1::Edit>& messages);

v1::Stroke to_wire(const Stroke& stroke);

v1::SetTransferCurve to_wire(const TransferCurve& curve);
Result<TransferCurve> from_wire(const v1::SetTransferCurve& message);

v1::Controls to_wire(const Controls& controls);
/// The range of the cap is checked with its edit.
Controls from_wire(const v1::Controls& message);

/// Appends the cells of a message, or of a part of an upload, to `change`.
/// Fails: resource_exhausted above kCellFieldsPerEditMax.
Status append_cells(const v1::SetCellFields& message, SetCellFields& change);

/// Cells first..first+count of a change, for an upload in parts.
v1::SetCellFields to_wire(const SetCellFields& change, size_t first, size_t count);

/// 1 to kEditIdBytesMax printable ASCII characters, else invalid_argument.
Status check_edit_id(const std::string& id);

}  // namespace burnish

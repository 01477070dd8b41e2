#pragma once

#include <string>

#include "client/model/workspace/workspace.h"
#include "client/web/core/front_state.h"
#include "client/web/core/json_writer.h"

namespace burnish {

/// Returns the model's state as JSON: a Snapshot of client/web/page/src/snapshot.ts.
std::string snapshot_of(Workspace& workspace, FrontState& state);

/// Returns the scale bar and the axes over the picture: a `guides` message of protocol.ts.
std::string guides_of(const Workspace& workspace);

/// Writes the open session: a Document of the same file. Needs: a document.
void write_document(Workspace& workspace, const FrontState& state, JsonWriter& json);

/// Writes what its panels for editing show: members of a Document.
void write_tools(const Workspace& workspace, JsonWriter& json);
/// Writes the panels that the window has too: likewise.
void write_panels(Workspace& workspace, JsonWriter& json);
/// Writes what its panels for looking show: likewise.
void write_view(const Workspace& workspace, JsonWriter& json);
/// Writes the section, or null: likewise.
void write_section(const Document& document, const FrontState& state, JsonWriter& json);
/// Writes the lines that lie over the picture: a member of a Document.
void write_over(const Workspace& workspace, JsonWriter& json);

}  // namespace burnish

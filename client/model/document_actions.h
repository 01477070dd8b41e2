#pragma once

#include "client/model/bindings.h"
#include "client/model/workspace.h"

namespace burnish {

/// What a key does to the open session and its picture; actions of the window alone do nothing
/// here. Needs: a document.
void do_document_action(Action action, Workspace& workspace);

}  // namespace burnish

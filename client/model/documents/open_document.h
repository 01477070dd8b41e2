#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "client/model/documents/document.h"
#include "common/base/progress.h"

namespace burnish {

/// Prepares a scan, opens its session, and fetches all data of a document. Sets `is_open` as soon
/// as the session is. Fails: as the server says; cancelled.
Result<OpenedDocument> open_document(std::shared_ptr<Connection> connection,
                                     const SessionWish& wish, const Progress& progress,
                                     std::atomic<bool>* is_open = nullptr);

/// Opens a fork of a session at another depth. Fails: as open_document().
Result<OpenedDocument> open_at_depth(std::shared_ptr<Connection> connection,
                                     const std::string& session, const ScanInfo& scan, int depth,
                                     const Progress& progress);

/// Fetches what a window must know of an open session before it shows it. Has pages made that are
/// missing. Fails: as the server says; data_loss; cancelled.
Result<OpenedDocument> fetch_document(std::shared_ptr<Connection> connection,
                                      const SessionInfo& session, const Progress& progress);

}  // namespace burnish

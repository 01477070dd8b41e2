#pragma once

#include <memory>
#include <string>

#include "common/base/status.h"
#include "server/journal/journal.h"
#include "server/library/data_folder.h"

namespace burnish {

/// Opens the journal of a database, or of the folder if `uri` is empty. Fails: as they say.
Result<std::unique_ptr<Journal>> open_journal(const std::string& uri, const DataFolder& folder);

/// Copies a journal, and says how much it was. Each name is a data folder, which is locked
/// meanwhile, or the URI of a database. Fails: as copy_journal() and the journals say.
Status copy_journal_of(const std::string& from, const std::string& to);

}  // namespace burnish

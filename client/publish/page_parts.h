#pragma once

#include "client/connection/recorded_answers.h"
#include "client/publish/parts_writer.h"
#include "client/publish/resting_surface.h"

namespace burnish {

/// Writes the parts of a scan's pages: all blocks of the directory, then of each page the page
/// and the packed tiles of its surface, its colours and its gains, each as a message of the
/// protocol but for the tiles (published_tile.h). Fails: data_loss (a damaged page), as the server
/// says, as writing does, cancelled.
Status write_page_parts(Connection& connection, const Opening& opening, RestingSurface& surface,
                        PartsWriter& parts, const Progress& progress);

/// How many sheets the page with the most has; 0: the scan has no pictures.
using SheetsPerPage = uint32_t;

/// Writes the parts of a scan's sheets: all blocks of their directory, then of each page its charts
/// and `SheetsPerPage` sheets, the finest first; an absent one is empty. Writes nothing for a scan
/// without pictures. Fails: likewise.
Result<SheetsPerPage> write_sheet_parts(Connection& connection, const Opening& opening,
                                        PartsWriter& parts, const Progress& progress);

}  // namespace burnish

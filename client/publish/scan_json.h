#pragma once

#include <string>

#include "client/connection/recorded_answers.h"
#include "client/publish/parts_writer.h"
#include "client/report/processing_record.h"

namespace burnish {

/// The content of scan.json of a publication.
struct PublishedScan {
  std::string title;
  std::string credit;
  ProcessingRecord record;
  Opening opening;
  PartsFiles files;
  uint32_t blocks = 0;
  uint32_t pages = 0;
  uint32_t sheets_per_page = 0;
  std::string welcome;  ///< messages of the live session (recorded_answers.h)
  std::string frame;
  float largest_move = 0;  ///< of the whole surface, cells
};

/// The first key of scan.json, by which a publication is known.
inline constexpr const char* kPublicationKey = "burnish_publication";

/// Returns the scan as JSON. docs/formats.md describes the fields.
std::string scan_json(const PublishedScan& scan);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "server/prepare/prepared_file.h"

namespace burnish {

// Checks of a prepared file before use, in the order in which they build on one another. All fail
// with data_loss; the caller adds the path.

/// Checks magic, version, length, checksum and the table of sections.
Status check_header(const PreparedHeader& header, uint64_t actual_file_bytes);

/// Checks that scalars are finite and in range.
Status check_scalars(const PreparedHeader& header);

/// Needs: check_header passed. Reads every byte.
Status check_section_checksums(const PreparedHeader& header, std::span<const uint8_t> file);

/// Checks that counts agree with one another, and that indices and keys are in range.
Status check_contents(const PreparedMesh& prepared);

}  // namespace burnish

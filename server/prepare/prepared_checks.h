#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "server/prepare/prepared_file.h"

namespace burnish {

// What must hold of a prepared file before anyone relies on it, in the order in which the checks
// build on one another. All fail with data_loss; the caller adds the path.

/// Magic, version, length, checksum and the table of sections.
Status check_header(const PreparedHeader& header, uint64_t actual_file_bytes);

/// Scalars finite and in range.
Status check_scalars(const PreparedHeader& header);

/// Needs: check_header passed. Reads every byte.
Status check_section_checksums(const PreparedHeader& header, std::span<const uint8_t> file);

/// Counts agree with one another; indices and keys are in range.
Status check_contents(const PreparedMesh& prepared);

}  // namespace burnish

#include "common/wire/library_wire.h"

#include "common/base/text.h"
#include "common/transfer/content_hash.h"
#include "common/wire/edit_wire.h"
#include "common/wire/format_wire.h"

namespace burnish {

v1::ImportHeader to_wire(const ImportHeader& header) {
  v1::ImportHeader message;
  message.set_name(header.name);
  message.set_format(to_wire(header.format));
  message.set_size_bytes(header.size_bytes);
  message.set_sha256(header.sha256);
  message.set_depth(header.key.depth);
  message.set_curvature_radius(header.key.curvature_radius);
  message.set_exact_name(header.exact_name);
  return message;
}

Result<ImportHeader> from_wire(const v1::ImportHeader& message) {
  ImportHeader header;
  RETURN_IF_ERROR(check_name("the scan's name", message.name()));
  header.name = message.name();
  ASSIGN_OR_RETURN(header.format, from_wire(message.format()));
  if (message.size_bytes() == 0) return invalid_argument("the scan's file has 0 bytes");
  header.size_bytes = message.size_bytes();
  if (!message.sha256().empty() && !is_content_hash(message.sha256()))
    return invalid_argument("sha256 is not 64 lower-case hexadecimal digits");
  header.sha256 = message.sha256();
  ASSIGN_OR_RETURN(header.key, prepared_key_from_wire(message.depth(), message.curvature_radius()));
  header.exact_name = message.exact_name();
  return header;
}

static v1::ScanStatistics to_wire(const MeshStatistics& statistics) {
  v1::ScanStatistics message;
#define BURNISH_FIELD(name) message.set_##name(statistics.name);
  BURNISH_STATISTICS_NUMBERS(BURNISH_FIELD)
#undef BURNISH_FIELD
  *message.mutable_box_min() = to_wire(statistics.box_min);
  *message.mutable_box_max() = to_wire(statistics.box_max);
  return message;
}

static MeshStatistics from_wire(const v1::ScanStatistics& message) {
  MeshStatistics statistics;
#define BURNISH_FIELD(name) statistics.name = message.name();
  BURNISH_STATISTICS_NUMBERS(BURNISH_FIELD)
#undef BURNISH_FIELD
  statistics.box_min = from_wire(message.box_min());
  statistics.box_max = from_wire(message.box_max());
  return statistics;
}

v1::ScanInfo to_wire(const ScanInfo& scan) {
  v1::ScanInfo message;
#define BURNISH_FIELD(name) message.set_##name(scan.name);
  BURNISH_SCAN_FIELDS(BURNISH_FIELD)
#undef BURNISH_FIELD
  message.set_format(to_wire(scan.format));
  *message.mutable_statistics() = to_wire(scan.statistics);
  for (const PreparedInfo& prepared : scan.prepared) {
    v1::PreparedInfo* entry = message.add_prepared();
    entry->set_depth(prepared.key.depth);
    entry->set_curvature_radius(prepared.key.curvature_radius);
    entry->set_size_bytes(prepared.size_bytes);
  }
  return message;
}

Result<ScanInfo> from_wire(const v1::ScanInfo& message) {
  ScanInfo scan;
  if (!is_content_hash(message.id()))
    return invalid_argument("scan id '" + message.id() + "' is not a SHA-256");
#define BURNISH_FIELD(name) scan.name = message.name();
  BURNISH_SCAN_FIELDS(BURNISH_FIELD)
#undef BURNISH_FIELD
  ASSIGN_OR_RETURN(scan.format, from_wire(message.format()));
  scan.statistics = from_wire(message.statistics());
  for (const v1::PreparedInfo& entry : message.prepared()) {
    ASSIGN_OR_RETURN(const PreparedKey key,
                     prepared_key_from_wire(entry.depth(), entry.curvature_radius()));
    scan.prepared.push_back({key, entry.size_bytes()});
  }
  return scan;
}

static v1::PreparedDescription to_wire(const PreparedDescription& prepared) {
  v1::PreparedDescription message;
  message.set_depth(prepared.key.depth);
  message.set_curvature_radius(prepared.key.curvature_radius);
  message.set_length_unit(prepared.length_unit);
  message.set_cell_size(prepared.cell_size);
  message.set_cells(prepared.cells);
  message.set_memory_bytes(prepared.memory_bytes);
  message.set_histogram_range(prepared.histogram_range);
  message.mutable_histogram()->Assign(prepared.histogram.begin(), prepared.histogram.end());
  if (prepared.walls.share > 0) *message.mutable_walls() = to_wire(prepared.walls);
  return message;
}

static Result<PreparedDescription> from_wire(const v1::PreparedDescription& message) {
  PreparedDescription prepared;
  ASSIGN_OR_RETURN(prepared.key,
                   prepared_key_from_wire(message.depth(), message.curvature_radius()));
  prepared.length_unit = message.length_unit();
  prepared.cell_size = message.cell_size();
  prepared.cells = message.cells();
  prepared.memory_bytes = message.memory_bytes();
  prepared.histogram_range = message.histogram_range();
  prepared.histogram.assign(message.histogram().begin(), message.histogram().end());
  prepared.walls = from_wire(message.walls());
  return prepared;
}

v1::ScanDescription to_wire(const ScanDescription& description) {
  v1::ScanDescription message;
  *message.mutable_scan() = to_wire(description.scan);
  if (description.prepared) *message.mutable_prepared() = to_wire(*description.prepared);
  return message;
}

Result<ScanDescription> from_wire(const v1::ScanDescription& message) {
  ScanDescription description;
  ASSIGN_OR_RETURN(description.scan, from_wire(message.scan()));
  if (message.has_prepared()) {
    ASSIGN_OR_RETURN(description.prepared, from_wire(message.prepared()));
  }
  return description;
}

v1::EdgeProposal to_wire(const EdgeProposal& proposal) {
  v1::EdgeProposal message;
  message.set_noise(proposal.noise);
  message.set_mean_edge(proposal.mean_edge);
  message.set_machined(proposal.is_machined);
  *message.mutable_filter() = to_wire(proposal.filter);
  return message;
}

Result<EdgeProposal> from_wire(const v1::EdgeProposal& message) {
  ASSIGN_OR_RETURN(const EdgeFilter filter, from_wire(message.filter()));
  return EdgeProposal{message.noise(), message.mean_edge(), message.machined(), filter};
}

}  // namespace burnish

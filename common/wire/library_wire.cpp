#include "common/wire/library_wire.h"

#include "common/base/text.h"
#include "common/transfer/content_hash.h"
#include "common/wire/edit_wire.h"
#include "common/wire/format_wire.h"

namespace burnish {

v1::ImportHeader to_wire(const ImportHeader& header) {
  v1::ImportHeader message;
  write_fields(header, message);
  message.set_format(to_wire(header.format));
  return message;
}

Result<ImportHeader> from_wire(const v1::ImportHeader& message) {
  auto header = read_record<ImportHeader>(message);
  RETURN_IF_ERROR(check_name("the scan's name", header.name));
  ASSIGN_OR_RETURN(header.format, from_wire(message.format()));
  if (header.size_bytes == 0) return invalid_argument("the scan's file has 0 bytes");
  if (!header.sha256.empty() && !is_content_hash(header.sha256))
    return invalid_argument("sha256 is not 64 lower-case hexadecimal digits");
  ASSIGN_OR_RETURN(header.key, prepared_key_from_wire(header.key));
  return header;
}

static v1::ScanStatistics to_wire(const MeshStatistics& statistics) {
  v1::ScanStatistics message;
  write_fields(statistics, message);
  *message.mutable_box_min() = to_wire(statistics.box_min);
  *message.mutable_box_max() = to_wire(statistics.box_max);
  return message;
}

static MeshStatistics from_wire(const v1::ScanStatistics& message) {
  auto statistics = read_record<MeshStatistics>(message);
  statistics.box_min = from_wire(message.box_min());
  statistics.box_max = from_wire(message.box_max());
  return statistics;
}

v1::ScanInfo to_wire(const ScanInfo& scan) {
  v1::ScanInfo message;
  write_fields(scan, message);
  message.set_format(to_wire(scan.format));
  *message.mutable_statistics() = to_wire(scan.statistics);
  for (const PreparedInfo& prepared : scan.prepared)
    write_fields(prepared, *message.add_prepared());
  return message;
}

Result<ScanInfo> from_wire(const v1::ScanInfo& message) {
  ScanInfo scan;
  if (!is_content_hash(message.id()))
    return invalid_argument("scan id '" + message.id() + "' is not a SHA-256");
  read_fields(message, scan);
  ASSIGN_OR_RETURN(scan.format, from_wire(message.format()));
  scan.statistics = from_wire(message.statistics());
  for (const v1::PreparedInfo& entry : message.prepared()) {
    PreparedInfo& prepared = scan.prepared.emplace_back();
    read_fields(entry, prepared);
    ASSIGN_OR_RETURN(prepared.key, prepared_key_from_wire(prepared.key));
  }
  return scan;
}

static v1::PreparedDescription to_wire(const PreparedDescription& prepared) {
  v1::PreparedDescription message;
  write_fields(prepared, message);
  message.set_histogram_range(prepared.histogram_range);
  for (const auto fraction : prepared.histogram) message.add_histogram(fraction);
  if (prepared.walls.share > 0) *message.mutable_walls() = to_wire(prepared.walls);
  return message;
}

static Result<PreparedDescription> from_wire(const v1::PreparedDescription& message) {
  auto prepared = read_record<PreparedDescription>(message);
  ASSIGN_OR_RETURN(prepared.key, prepared_key_from_wire(prepared.key));
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

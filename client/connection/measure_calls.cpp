#include "client/connection/event_stream.h"
#include "common/wire/library_wire.h"
#include "common/wire/measures_wire.h"

namespace burnish {

Result<EdgeProposal> Connection::propose_edges(const std::string& scan, const Progress& progress) {
  grpc::ClientContext context;
  v1::ProposeEdgesRequest request;
  request.set_scan(scan);
  const auto reader = state_->library->ProposeEdges(&context, request);
  ASSIGN_OR_RETURN(const auto done,
                   read_until_done<v1::ProposeEdgesEvent>(server(), context, *reader, progress,
                                                          "measuring the noise"));
  return from_wire(done);
}

Result<SessionDeviation> Connection::deviation(const std::string& session) {
  v1::GetDeviationRequest request;
  request.set_session(session);
  v1::Deviation response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    return owner.GetDeviation(&context, request, &response);
  }));
  return from_wire(response);
}

Result<Section> Connection::section(const SectionWish& wish) {
  v1::Section response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    return owner.GetSection(&context, to_wire(wish), &response);
  }));
  return from_wire(response);
}

Result<ScanInfo> Connection::set_scan_unit(const std::string& scan, const std::string& unit) {
  grpc::ClientContext context;
  state_->set_deadline(context);
  state_->set_user(context);
  v1::SetScanUnitRequest request;
  request.set_scan(scan);
  request.set_unit(unit);
  v1::ScanInfo response;
  RETURN_IF_ERROR(
      call_status(server(), state_->library->SetScanUnit(&context, request, &response)));
  return from_wire(response);
}

}  // namespace burnish

#include "tests/system/restless_openers.h"

#include <algorithm>
#include <functional>
#include <set>

#include "common/base/check.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr char kApplied[] = "applied";
constexpr milliseconds kNoHurry{
    5000};  // longer than an answer takes, short enough for a dead server

void set_deadline(grpc::ClientContext& context, milliseconds time) {
  context.set_deadline(std::chrono::system_clock::now() + time);
}

grpc::Status open(v1::Editing::Stub& stub, const v1::OpenSessionRequest& request,
                  milliseconds patience) {
  grpc::ClientContext context;
  set_deadline(context, patience);
  v1::OpenSessionResponse response;
  return stub.OpenSession(&context, request, &response);
}

v1::OpenSessionRequest wish(const std::string& scan, const std::string& session) {
  v1::OpenSessionRequest request;
  request.set_scan(scan);
  request.set_name(session);
  return request;
}

/// Returns nothing if there is no such session.
std::multiset<std::string> edit_ids(v1::Editing::Stub& stub, const std::string& session) {
  std::multiset<std::string> ids;
  v1::GetHistoryRequest request;
  request.set_session(session);
  v1::GetHistoryResponse page;
  do {
    grpc::ClientContext context;
    set_deadline(context, kPatience);
    if (!stub.GetHistory(&context, request, &page).ok()) break;
    for (const v1::HistoryEntry& entry : page.entries()) {
      ids.insert(entry.edit_id());
      request.set_after(entry.number());
    }
  } while (!page.complete());
  return ids;
}

std::set<std::string> session_names(v1::Editing::Stub& stub) {
  grpc::ClientContext context;
  set_deadline(context, kPatience);
  v1::ListSessionsResponse response;
  (void)stub.ListSessions(&context, {}, &response);
  std::set<std::string> names;
  for (const v1::SessionInfo& session : response.sessions()) names.insert(session.name());
  return names;
}

}  // namespace

RestlessOpeners::RestlessOpeners(std::string address, std::string scan, const Vec3i& cell,
                                 uint32_t seed)
    : address_(std::move(address)), scan_(std::move(scan)), cell_(cell), random_(seed) {
  const auto stub = v1::Editing::NewStub(wire_channel(address_));
  const grpc::Status opened = open(*stub, wish(scan_, kApplied), kPatience);
  BURNISH_CHECK(opened.ok(), opened.error_message());
}

void RestlessOpeners::start() {
  stopping_ = false;
  thread_ = std::thread([this] {
    const auto stub = v1::Editing::NewStub(wire_channel(address_));
    run(*stub);
  });
}

void RestlessOpeners::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void RestlessOpeners::run(Stub& stub) {
  while (!stopping_) {
    // An edit without an answer is sent again to the next server, with the same id.
    if (apply(stub, kApplied, "edit-" + std::to_string(edits_))) ++edits_;
    if (random_() % 8 == 0) forge(stub);
    if (random_() % 8 == 0) race(stub);
    if (random_() % 8 == 0) fork(stub);
  }
}

// A fork has the edits that were acknowledged before, perhaps one more.
void RestlessOpeners::fork(Stub& stub) {
  const std::string session = "fork-" + std::to_string(forks_++);
  v1::ForkSessionRequest request;
  request.set_session(kApplied);
  request.set_name(session);
  const std::vector<std::string> edits = acknowledged_[kApplied];
  grpc::ClientContext context;
  set_deadline(context, kNoHurry);
  v1::ForkSessionResponse response;
  if (!stub.ForkSession(&context, request, &response).ok()) return;
  forked_.insert(session);
  acknowledged_[session] = edits;
}

void RestlessOpeners::race(Stub& stub) {
  const std::string session = "race-" + std::to_string(races_++);
  v1::OpenSessionRequest request = wish(scan_, session);
  // A new radius needs a preparation, so there is work to give up.
  request.set_curvature_radius(0.01 + 1e-6 * races_);
  const milliseconds patience(1 + random_() % 60), head_start(random_() % 30);
  std::thread first([&] { (void)open(stub, request, patience); });
  std::this_thread::sleep_for(head_start);  // picks the moment of the race in the other process
  if (random_() % 2 == 0) {
    join(stub, session);
  } else if (open(stub, request, kNoHurry).ok()) {
    told_.insert(session);
    join(stub, session);
  }
  first.join();
}

void RestlessOpeners::join(Stub& stub, const std::string& session) {
  if (apply(stub, session, "joined")) told_.insert(session);
}

void RestlessOpeners::forge(Stub& stub) {
  grpc::ClientContext context;
  set_deadline(context, kNoHurry);
  v1::ListSessionsResponse known;
  if (!stub.ListSessions(&context, {}, &known).ok() || known.sessions().empty()) return;
  const int chosen = static_cast<int>(random_() % known.sessions_size());
  const std::string& id = known.sessions(chosen).id();
  if (open(stub, wish(scan_, id), kNoHurry).ok()) wrongly_opened_.push_back(id);
}

bool RestlessOpeners::apply(Stub& stub, const std::string& session, const std::string& edit_id) {
  v1::ApplyRequest request;
  request.set_session(session);
  v1::Edit* edit = request.add_edits();
  edit->set_id(edit_id);
  if (std::hash<std::string>()(edit_id) % 2 == 0) {  // the same when it is sent again
    edit->mutable_gradient_scale()->set_beta(0.5);
  } else {
    v1::CellField& field = *edit->mutable_cell_fields()->add_cells();
    field.set_i(cell_.x());
    field.set_j(cell_.y());
    field.set_k(cell_.z());
    field.set_alpha1(20);
    field.set_alpha2(30);
    field.set_beta(0.5);
  }
  grpc::ClientContext context;
  set_deadline(context, kNoHurry);
  v1::ApplyResponse response;
  if (!stub.Apply(&context, request, &response).ok()) return false;
  acknowledged_[session].push_back(edit_id);
  return true;
}

std::vector<std::string> RestlessOpeners::broken_promises() const {
  std::vector<std::string> broken;
  const auto stub = v1::Editing::NewStub(wire_channel(address_));
  const std::set<std::string> there = session_names(*stub);
  for (const std::string& session : told_)
    if (!there.contains(session)) broken.push_back("session " + session + " is gone");
  for (const std::string& session : forked_)
    if (!there.contains(session)) broken.push_back("fork " + session + " is gone");
  for (const auto& [session, edits] : acknowledged_) {
    const std::multiset<std::string> found = edit_ids(*stub, session);
    for (const std::string& edit : edits)
      if (found.count(edit) != 1)
        broken.push_back("edit " + edit + " of session " + session + " is there " +
                         std::to_string(found.count(edit)) + " times");
  }
  for (const std::string& id : wrongly_opened_)
    broken.push_back("a session was opened whose name is the id " + id + " of another");
  return broken;
}

size_t RestlessOpeners::acknowledged() const {
  size_t edits = 0;
  for (const auto& [session, ids] : acknowledged_)
    if (!forked_.contains(session)) edits += ids.size();
  return edits;
}

}  // namespace burnish

// Ends every RPC in every way: the status must be right, and nothing may stay behind.

#include <csignal>
#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "common/transfer/chunk.h"
#include "tests/server/metrics/http_get.h"
#include "tests/server/prepare/sheets/painted_ball.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

/// Messages that make one RPC succeed, and messages that make it fail.
struct Rpc {
  std::string method;
  std::vector<std::string> good;
  std::vector<std::string> bad = {};  ///< empty: only its bytes can be wrong
  grpc::StatusCode refusal = grpc::StatusCode::NOT_FOUND;
  bool is_there_already = false;  ///< called again, to tidy up
  bool is_endless = false;        ///< runs until its client ends it
};

template <typename Message>
std::string bytes(const std::function<void(Message&)>& fill = {}) {
  Message message;
  if (fill) fill(message);
  return message.SerializeAsString();
}

template <typename Message>
std::string of_session(const std::string& name) {
  return bytes<Message>([&](Message& message) { message.set_session(name); });
}

std::string rename_session(const std::string& from, const std::string& to) {
  return bytes<v1::RenameSessionRequest>([&](v1::RenameSessionRequest& request) {
    request.set_session(from);
    request.set_name(to);
  });
}

std::string rename_scan(const std::string& from, const std::string& to) {
  return bytes<v1::RenameScanRequest>([&](v1::RenameScanRequest& request) {
    request.set_scan(from);
    request.set_name(to);
  });
}

std::string section_of(const std::string& session) {
  return bytes<v1::GetSectionRequest>([&](v1::GetSectionRequest& request) {
    request.set_session(session);
    request.mutable_direction()->set_z(1);
  });
}

std::string scan_unit(const std::string& scan) {
  return bytes<v1::SetScanUnitRequest>([&](v1::SetScanUnitRequest& request) {
    request.set_scan(scan);
    request.set_unit("mm");
  });
}

template <typename Message>
std::string of_scan(const std::string& name) {
  return bytes<Message>([&](Message& message) { message.set_scan(name); });
}

std::vector<std::string> import(const std::string& scan, uint64_t announced) {
  return {bytes<v1::ImportRequest>([&](v1::ImportRequest& request) {
            request.mutable_header()->set_name("ball");
            request.mutable_header()->set_format(v1::MESH_FORMAT_ZIP);
            request.mutable_header()->set_size_bytes(announced);
            request.mutable_header()->set_depth(4);
          }),
          bytes<v1::ImportRequest>([&](v1::ImportRequest& request) {
            request.mutable_chunk()->set_data(scan);
            request.mutable_chunk()->set_crc32(chunk_crc32(scan));
          })};
}

std::string first_page_of(const std::string& scan) {
  v1::FetchPagesRequest request;
  request.set_scan(scan);
  request.add_pages(0);
  return request.SerializeAsString();
}

std::string first_sheet_of(const std::string& scan) {
  v1::FetchSheetsRequest request;
  request.set_scan(scan);
  request.add_sheets()->set_page(0);
  return request.SerializeAsString();
}

/// Returns an archive of a small scan with a picture.
std::string textured_scan() {
  const std::vector<uint8_t> zip = PaintedBall{.quads_per_side = 8, .face_texels = 30}.zip();
  return {zip.begin(), zip.end()};
}

std::string open_session(const std::string& scan) {
  return bytes<v1::OpenSessionRequest>([&](v1::OpenSessionRequest& request) {
    request.set_scan(scan);
    request.set_name("work");
    request.set_depth(4);
  });
}

std::string apply(const std::string& session) {
  return bytes<v1::ApplyRequest>([&](v1::ApplyRequest& request) {
    request.set_session(session);
    v1::Edit* edit = request.add_edits();
    edit->set_id("one");
    edit->mutable_gradient_scale()->set_beta(0.5);
  });
}

std::string greeting(const std::string& session) {
  return bytes<v1::ClientMessage>([&](v1::ClientMessage& message) {
    message.mutable_greeting()->set_session(session);
    message.mutable_greeting()->set_pages(true);
  });
}

std::string watch(const std::string& session) {
  return bytes<v1::WatchRequest>([&](v1::WatchRequest& request) {
    request.mutable_greeting()->set_session(session);
    request.mutable_greeting()->set_pages(true);
    request.add_pages(0);
  });
}

std::string set_role(const std::string& session) {
  return bytes<v1::SetRoleRequest>([&](v1::SetRoleRequest& request) {
    request.set_session(session);
    request.set_user("bob");
    request.set_role(v1::ROLE_VIEWER);
  });
}

std::string fork_request(const std::string& session) {
  return bytes<v1::ForkSessionRequest>([&](v1::ForkSessionRequest& request) {
    request.set_session(session);
    request.set_name("copy");
  });
}

std::string cell_fields(const std::string& session) {
  return bytes<v1::UploadCellFieldsRequest>([&](v1::UploadCellFieldsRequest& request) {
    request.mutable_header()->set_session(session);
    request.mutable_header()->set_edit_id("cells");
  });
}

std::string cells(const std::string& session) {
  return bytes<v1::GetCellsRequest>([&](v1::GetCellsRequest& request) {
    request.set_session(session);
    request.set_value(v1::CELL_VALUE_BETA);
  });
}

std::string page_values(const std::string& session) {
  return bytes<v1::GetPageValuesRequest>([&](v1::GetPageValuesRequest& request) {
    request.set_session(session);
    request.set_value(v1::CELL_VALUE_BETA);
    request.add_pages(0);
  });
}

std::string export_of(const std::string& session) {
  return bytes<v1::ExportRequest>([&](v1::ExportRequest& request) {
    request.set_session(session);
    request.set_format(v1::MESH_FORMAT_PLY);
    request.set_cycles(1);
  });
}

/// Returns the RPCs in an order in which each finds its preconditions.
std::vector<Rpc> rpcs_in_order(const std::string& scan) {
  const std::string library = "/burnish.v1.Library/", editing = "/burnish.v1.Editing/";
  return {
      {library + "Import", import(scan, scan.size()), import(scan, scan.size() + 1),
       grpc::StatusCode::DATA_LOSS},
      {library + "ListScans", {""}},
      {library + "DescribeScan",
       {of_scan<v1::DescribeScanRequest>("ball")},
       {of_scan<v1::DescribeScanRequest>("none")}},
      {library + "PrepareScan",
       {of_scan<v1::PrepareScanRequest>("ball")},
       {of_scan<v1::PrepareScanRequest>("none")}},
      {library + "RenameScan", {rename_scan("ball", "ball")}, {rename_scan("none", "ball")}},
      {library + "SetScanUnit", {scan_unit("ball")}, {scan_unit("none")}},
      {library + "DescribePages",
       {of_scan<v1::DescribePagesRequest>("ball")},
       {of_scan<v1::DescribePagesRequest>("none")}},
      {library + "ProposeEdges",
       {of_scan<v1::ProposeEdgesRequest>("ball")},
       {of_scan<v1::ProposeEdgesRequest>("none")}},
      {library + "FetchPages", {first_page_of("ball")}, {first_page_of("none")}},
      {library + "DescribeSheets",
       {of_scan<v1::DescribeSheetsRequest>("ball")},
       {of_scan<v1::DescribeSheetsRequest>("none")}},
      {library + "FetchSheets", {first_sheet_of("ball")}, {first_sheet_of("none")}},
      {editing + "OpenSession", {open_session("ball")}, {open_session("none")}},
      {editing + "ListSessions", {""}},
      {editing + "Apply", {apply("work")}, {apply("none")}},
      {editing + "UploadCellFields", {cell_fields("work")}, {cell_fields("none")}},
      {editing + "RenameSession",
       {rename_session("work", "work")},
       {rename_session("none", "work")}},
      {editing + "GetState",
       {of_session<v1::GetStateRequest>("work")},
       {of_session<v1::GetStateRequest>("none")}},
      {editing + "GetHistory",
       {of_session<v1::GetHistoryRequest>("work")},
       {of_session<v1::GetHistoryRequest>("none")}},
      {editing + "GetPeople",
       {of_session<v1::GetPeopleRequest>("work")},
       {of_session<v1::GetPeopleRequest>("none")}},
      {editing + "GetCells", {cells("work")}, {cells("none")}},
      {editing + "GetPageValues", {page_values("work")}, {page_values("none")}},
      {editing + "GetDeviation",
       {of_session<v1::GetDeviationRequest>("work")},
       {of_session<v1::GetDeviationRequest>("none")}},
      {editing + "GetSection", {section_of("work")}, {section_of("none")}},
      {editing + "SetRole", {set_role("work")}, {set_role("none")}},
      {editing + "Edit", {greeting("work")}, {greeting("none")}},
      {editing + "Watch",
       {watch("work")},
       {watch("none")},
       grpc::StatusCode::NOT_FOUND,
       false,
       true},
      {editing + "ForkSession", {fork_request("work")}, {fork_request("none")}},
      {editing + "DeleteSession",
       {of_session<v1::DeleteSessionRequest>("copy")},
       {of_session<v1::DeleteSessionRequest>("none")},
       grpc::StatusCode::NOT_FOUND,
       true},
      {editing + "Export", {export_of("work")}, {export_of("none")}},
      {editing + "CloseSession",
       {of_session<v1::CloseSessionRequest>("work")},
       {of_session<v1::CloseSessionRequest>("none")}},
      {editing + "DeleteSession",
       {of_session<v1::DeleteSessionRequest>("work")},
       {of_session<v1::DeleteSessionRequest>("none")}},
      {library + "DeleteScan",
       {of_scan<v1::DeleteScanRequest>("ball")},
       {of_scan<v1::DeleteScanRequest>("none")}},
  };
}

class Outcomes : public testing::Test {
 protected:
  Outcomes()
      : server_({"--metrics", "127.0.0.1:0"}),
        channel_(wire_channel(server_.address)),
        rpcs_(rpcs_in_order(textured_scan())) {}

  /// Waits until no object of these kinds is alive.
  void expect_nothing_left(const std::vector<std::string>& kinds) const {
    const int port = std::stoi(server_.announced("metrics on port "));
    for (const std::string& kind : kinds) {
      const std::string gauge = "burnish_live_objects{kind=\"" + kind + "\"}";
      double alive = -1;
      for (int i = 0; i < 3000 && alive != 0; ++i) {
        alive = metric(http_get_metrics(port), gauge);
        if (alive != 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      EXPECT_EQ(alive, 0) << kind;
    }
  }

  WireAnswer run(const Rpc& rpc, const std::function<void(WireCall&)>& change = {}) {
    WireCall wire{rpc.method, rpc.good};
    wire.enough_messages = rpc.is_endless ? 1 : 0;
    if (change) change(wire);
    return call(channel_, wire);
  }

  ServerProcess server_;
  std::shared_ptr<grpc::Channel> channel_;
  std::vector<Rpc> rpcs_;
};

TEST_F(Outcomes, OfGoodCallsAreOkAndNothingIsLeft) {
  std::vector<std::string> called;
  for (const Rpc& rpc : rpcs_) {
    const grpc::Status status = run(rpc).status;
    EXPECT_TRUE(status.ok()) << rpc.method << ": " << status.error_message();
    if (!rpc.is_there_already) called.push_back(rpc.method);
  }
  EXPECT_THAT(called, testing::UnorderedElementsAreArray(all_rpcs()));
  expect_nothing_left({"call", "mesh", "session", "upload", "export"});
}

TEST_F(Outcomes, OfWrongCallsNameTheReason) {
  for (const Rpc& rpc : rpcs_) {
    const std::vector<std::string> nonsense = {"\xff\xff\xff"};
    const grpc::Status malformed =
        run(rpc, [&](WireCall& wire) { wire.messages = nonsense; }).status;
    EXPECT_EQ(malformed.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << rpc.method;
    if (rpc.bad.empty()) continue;
    const grpc::Status status = run(rpc, [&](WireCall& wire) { wire.messages = rpc.bad; }).status;
    EXPECT_EQ(status.error_code(), rpc.refusal) << rpc.method << ": " << status.error_message();
  }
  expect_nothing_left({"call", "mesh", "session", "upload", "export"});
}

TEST_F(Outcomes, OfCallsThatAreCancelledOrOverdueSaySo) {
  for (const Rpc& rpc : rpcs_) {
    WireCall waiting{rpc.method, {}};  // any RPC waits here for messages that never come
    waiting.keep_open = true;
    waiting.deadline = std::chrono::milliseconds(100);  // gRPC's, by its own clock
    EXPECT_EQ(call(channel_, waiting).status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED)
        << rpc.method;
    waiting.deadline = kPatience;
    waiting.cancel = true;
    EXPECT_EQ(call(channel_, waiting).status.error_code(), grpc::StatusCode::CANCELLED)
        << rpc.method;
  }
  expect_nothing_left({"call", "mesh", "session", "upload", "export"});
}

TEST_F(Outcomes, OfCallsThatAreCancelledAtWorkLeaveNothing) {
  for (const Rpc& rpc : rpcs_) {
    // The call may end before its cancel arrives.
    const grpc::StatusCode code =
        run(rpc, [](WireCall& wire) { wire.cancel = true; }).status.error_code();
    EXPECT_THAT(code, testing::AnyOf(grpc::StatusCode::CANCELLED, grpc::StatusCode::OK))
        << rpc.method;
    run(rpc);
  }
  expect_nothing_left({"call", "mesh", "session", "upload", "export"});
}

TEST_F(Outcomes, OfAServerThatEndsAreOkOrUnavailable) {
  std::vector<std::thread> clients;
  std::atomic<int> others{0};
  std::atomic<size_t> answered{0};
  std::atomic<bool> gone{false};
  for (int i = 0; i < 4; ++i)
    clients.emplace_back([&, this] {
      while (!gone)
        for (const Rpc& rpc : rpcs_) {
          const grpc::StatusCode code = run(rpc).status.error_code();
          // Four clients also delete each other's sessions and scans.
          const bool right =
              code == grpc::StatusCode::OK || code == grpc::StatusCode::UNAVAILABLE ||
              code == grpc::StatusCode::CANCELLED || code == grpc::StatusCode::NOT_FOUND ||
              code == grpc::StatusCode::ALREADY_EXISTS ||
              code == grpc::StatusCode::FAILED_PRECONDITION;
          others += right ? 0 : 1;
          ++answered;
          if (code == grpc::StatusCode::UNAVAILABLE) gone = true;
        }
    });
  while (answered < rpcs_.size() && !gone)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  server_.process->signal(SIGTERM);
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(others, 0);
  EXPECT_EQ(server_.process->wait(kPatience), 0) << server_.process->output();
}

}  // namespace
}  // namespace burnish

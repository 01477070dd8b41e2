// Uploads that send bytes that do not parse, or wrong messages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "common/transfer/chunk.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr char kNoMessage[] = "\xff\xff\xff";

class MalformedUpload : public testing::Test {
 protected:
  double counted() const {
    return metric(http_get_metrics(std::stoi(server_.announced("metrics on port "))),
                  "burnish_refusals_total{reason=\"malformed\"}");
  }

  /// Sends the messages and expects that the last is refused for `reason`.
  void expect_refused(const std::string& method, const std::vector<std::string>& messages,
                      const std::string& reason) {
    const double before = counted();
    const grpc::Status status =
        call(wire_channel(server_.address), {.method = method, .messages = messages}).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_THAT(status.error_message(), HasSubstr(reason));
    EXPECT_EQ(counted(), before + 1) << reason;
    EXPECT_TRUE(server_.process->wait_for_output(reason, kPatience));
  }

  ServerProcess server_{{"--metrics", "127.0.0.1:0"}};
};

TEST_F(MalformedUpload, OfAScanIsRefusedLoggedAndCounted) {
  const std::string method = "/burnish.v1.Library/Import";
  const std::string scan = content_of(write_sphere(server_.folder));
  v1::ImportRequest header, chunk, neither;
  header.mutable_header()->set_name("ball");
  header.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
  header.mutable_header()->set_size_bytes(scan.size());
  chunk.mutable_chunk()->set_data(scan);
  chunk.mutable_chunk()->set_crc32(chunk_crc32(scan));
  const std::string begin = header.SerializeAsString(), all = chunk.SerializeAsString();
  expect_refused(method, {kNoMessage}, "not a valid ImportRequest");
  expect_refused(method, {begin, kNoMessage}, "not a valid ImportRequest");
  expect_refused(method, {begin, all, kNoMessage}, "not a valid ImportRequest");
  expect_refused(method, {begin, begin}, "only one header");
  expect_refused(method, {all}, "begin with its header");
  expect_refused(method, {begin, neither.SerializeAsString()}, "a header or a chunk");
  EXPECT_EQ(server_.scans(), 0u);
}

TEST_F(MalformedUpload, OfCellFieldsIsRefusedLoggedAndCounted) {
  const std::string method = "/burnish.v1.Editing/UploadCellFields";
  v1::UploadCellFieldsRequest header, cells;
  header.mutable_header()->set_session("work");
  header.mutable_header()->set_edit_id("cells");
  cells.mutable_cells();
  const std::string begin = header.SerializeAsString();
  expect_refused(method, {kNoMessage}, "not a valid UploadCellFieldsRequest");
  expect_refused(method, {begin, kNoMessage}, "not a valid UploadCellFieldsRequest");
  expect_refused(method, {begin, begin}, "only one header");
  expect_refused(method, {cells.SerializeAsString()}, "begin with its header");
}

}  // namespace
}  // namespace burnish

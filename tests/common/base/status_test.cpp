#include "common/base/status.h"

#include <cerrno>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace burnish {

TEST(Status, SaysItsCodeAndMessage) {
  EXPECT_EQ(Status::ok().to_string(), "ok");
  EXPECT_EQ(invalid_argument("depth 13 is outside 4..12").to_string(),
            "invalid argument: depth 13 is outside 4..12");
}

TEST(Status, ContextGoesBeforeTheMessageAndKeepsTheCode) {
  const Status status = not_found("no vertex").with_context("a.ply");
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_EQ(status.message(), "a.ply: no vertex");
  EXPECT_TRUE(Status::ok().with_context("a.ply").is_ok());
}

TEST(Status, AThingGetsAnotherNameWhereverTheMessageHasIt) {
  const Status status =
      data_loss("/tmp/x.ply ends; /tmp/x.ply has 3 bytes").renamed("/tmp/x.ply", "out.ply");
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_EQ(status.message(), "out.ply ends; out.ply has 3 bytes");
  EXPECT_EQ(data_loss("a").renamed("", "b").message(), "a");
  EXPECT_TRUE(Status::ok().renamed("a", "b").is_ok());
}

TEST(Status, EveryCodeHasAName) {
  for (int code = 0; code <= static_cast<int>(StatusCode::kInternal); ++code)
    EXPECT_STRNE(status_code_name(static_cast<StatusCode>(code)), "unknown") << code;
}

TEST(Status, ErrnoBecomesTheCodeThatACallerCanActOn) {
  EXPECT_EQ(errno_status("open", ENOENT).code(), StatusCode::kNotFound);
  EXPECT_EQ(errno_status("open", EACCES).code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(errno_status("write", ENOSPC).code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(errno_status("write", EIO).code(), StatusCode::kInternal);
  EXPECT_EQ(errno_status("write", ENOSPC).message(), "write: No space left on device");
}

TEST(Status, AnErrorWithTheCodeOkIsABrokenContract) {
  EXPECT_DEATH(Status(StatusCode::kOk, "no"), "an error needs an error's code");
}

static Result<int> half(int x) {
  if (x % 2 != 0) return invalid_argument(std::to_string(x) + " is odd");
  return x / 2;
}

static Result<int> quarter(int x) {
  ASSIGN_OR_RETURN(const int y, half(x));
  ASSIGN_OR_RETURN(const int z, half(y));
  return z;
}

static Status check_quarter(int x) {
  RETURN_IF_ERROR(quarter(x).status());
  return Status::ok();
}

TEST(Result, HoldsAValueOrTheReasonWhyNot) {
  ASSERT_TRUE(quarter(8).is_ok());
  EXPECT_EQ(*quarter(8), 2);
  EXPECT_EQ(quarter(6).status().message(), "3 is odd");
  EXPECT_EQ(check_quarter(5).message(), "5 is odd");
}

TEST(Result, CarriesValuesThatOnlyMove) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
  const std::unique_ptr<int> value = std::move(result).value();
  EXPECT_EQ(*value, 7);
}

TEST(Result, TakingTheValueOfAnErrorSaysTheErrorAndStops) {
  const Result<int> result = half(3);
  EXPECT_DEATH(static_cast<void>(result.value()), "3 is odd");
}

}  // namespace burnish

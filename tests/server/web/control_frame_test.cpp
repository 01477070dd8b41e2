#include "server/web/protocol/control_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/web/protocol/web_limits.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string refusal_of(const std::string& text) {
  return read_control_frame(text).status().message();
}

std::string call_with(const std::string& rest) {
  return R"({"call":"a.B/C",)" + rest + "}";
}

TEST(ControlFrame, EachKindIsRead) {
  EXPECT_EQ(read_control_frame(R"({"call":"a.B/C"})").value(),
            ControlFrame(CallFrame{"/a.B/C", "", std::nullopt}));
  EXPECT_EQ(read_control_frame(call_with(R"("user":"")")).value(),
            ControlFrame(CallFrame{"/a.B/C", "", ""}));
  EXPECT_EQ(read_control_frame(R"( {"end": true} )").value(), ControlFrame(EndFrame{}));
  EXPECT_EQ(read_control_frame(R"({"cancel":true})").value(), ControlFrame(CancelFrame{}));
}

TEST(ControlFrame, OtherTextIsRefused) {
  for (const char* text : {"", "{", "[]", "1", "null", "{}", R"({"hello":1})", R"({"end":false})",
                           R"({"end":1})", R"({"cancel":"true"})", R"({"call":1})",
                           R"({"call":"a","token":1})", R"({"call":"a","user":null})",
                           R"({"call":"a","end":true})", R"({"end":true,"cancel":true})"})
    EXPECT_EQ(read_control_frame(text).status().code(), StatusCode::kInvalidArgument) << text;
}

TEST(ControlFrame, TheRefusalNamesTheKey) {
  EXPECT_THAT(refusal_of(R"({"call":1})"), HasSubstr("'call'"));
  EXPECT_THAT(refusal_of(call_with(R"("token":[])")), HasSubstr("'token'"));
}

TEST(ControlFrame, ATokenWithOtherThanAsciiIsRefusedForGrpcWouldEndTheProcess) {
  for (const char* token : {R"(a\nb)", R"(\u0000)", R"(\u00fc)", R"(\u007f)"})
    EXPECT_THAT(refusal_of(call_with(R"("token":")" + std::string(token) + "\"")),
                HasSubstr("'token'"))
        << token;
}

TEST(ControlFrame, ATokenIsInNoMessage) {
  const std::string secret = "wonderful-secret";
  EXPECT_THAT(refusal_of(call_with(R"("token":")" + secret + R"(\n")")), Not(HasSubstr(secret)));
  EXPECT_THAT(refusal_of(call_with(R"("token":")" + secret)), Not(HasSubstr(secret)));
  EXPECT_THAT(refusal_of(call_with("\"" + secret + "\":1")), Not(HasSubstr(secret)));
}

TEST(ControlFrame, LengthsHaveLimits) {
  const std::string most(kWebTokenBytesMax, 't');
  EXPECT_TRUE(read_control_frame(call_with(R"("token":")" + most + "\"")).is_ok());
  EXPECT_THAT(refusal_of(call_with(R"("token":"t)" + most + "\"")), HasSubstr("1025 bytes"));
  EXPECT_THAT(refusal_of(std::string(kWebControlBytesMax + 1, ' ')), HasSubstr("8193 bytes"));
}

TEST(ControlFrame, DeepNestingIsOnlyRefused) {
  EXPECT_FALSE(read_control_frame(std::string(kWebControlBytesMax, '[')).is_ok());
}

TEST(ControlFrame, AnEndHasTheCodeAndTheMessage) {
  EXPECT_EQ(end_of_call_frame(0, ""), R"({"code":0,"message":""})");
  EXPECT_EQ(end_of_call_frame(9, "moved", std::string("\n\x03one", 5)),
            R"({"code":9,"message":"moved","details":"0a036f6e65"})");
  EXPECT_EQ(end_of_call_frame(5, "no \"x\""), R"({"code":5,"message":"no \"x\""})");
}

TEST(ControlFrame, AnEndIsUtf8WhateverTheMessage) {
  EXPECT_EQ(end_of_call_frame(2, "a\xff"), "{\"code\":2,\"message\":\"a\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace burnish

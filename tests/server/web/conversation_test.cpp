#include "server/web/protocol/conversation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/web/protocol/web_limits.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr char kCallText[] = R"({"call":"a.B/C"})";
constexpr char kEndText[] = R"({"end":true})";
constexpr char kCancelText[] = R"({"cancel":true})";

template <typename What>
bool is(const Order& order) {
  return std::holds_alternative<What>(order);
}

CloseCode close_code(const Order& order) {
  return std::get<CloseSocket>(order).code;
}

TEST(Conversation, ACallTakesMessagesToTheirEnd) {
  Conversation talk;
  const Order start = talk.hear_text(R"({"call":"a.B/C","token":"t","user":"anna"})");
  EXPECT_EQ(std::get<StartCall>(start).call, (CallFrame{"/a.B/C", "t", "anna"}));
  EXPECT_TRUE(talk.is_calling());
  EXPECT_TRUE(talk.takes_messages());
  EXPECT_TRUE(is<PassMessage>(talk.hear_message(0)));
  EXPECT_TRUE(is<PassMessage>(talk.hear_message(kWebMessageBytesMax)));
  EXPECT_TRUE(is<EndMessages>(talk.hear_text(kEndText)));
  EXPECT_FALSE(talk.takes_messages());
  EXPECT_TRUE(talk.is_calling());
  talk.note_end();
  EXPECT_FALSE(talk.is_calling());
}

TEST(Conversation, TheNextCallComesAfterTheEnd) {
  Conversation talk;
  talk.hear_text(kCallText);
  talk.note_end();
  EXPECT_TRUE(is<StartCall>(talk.hear_text(kCallText)));
}

TEST(Conversation, ASecondCallBesideTheFirstClosesTheSocket) {
  Conversation talk;
  talk.hear_text(kCallText);
  EXPECT_EQ(close_code(talk.hear_text(kCallText)), CloseCode::kProtocolError);
}

TEST(Conversation, LateFramesOfAnEndedCallAreDropped) {
  Conversation talk;
  talk.hear_text(kCallText);
  talk.note_end();
  EXPECT_TRUE(is<DropFrame>(talk.hear_message(5)));
  EXPECT_TRUE(is<DropFrame>(talk.hear_text(kEndText)));
  EXPECT_TRUE(is<DropFrame>(talk.hear_text(kCancelText)));
}

TEST(Conversation, NothingComesBeforeTheFirstCall) {
  EXPECT_EQ(close_code(Conversation().hear_message(5)), CloseCode::kProtocolError);
  EXPECT_EQ(close_code(Conversation().hear_text(kEndText)), CloseCode::kProtocolError);
  EXPECT_EQ(close_code(Conversation().hear_text(kCancelText)), CloseCode::kProtocolError);
}

TEST(Conversation, NothingFollowsTheMessagesEndButACancel) {
  Conversation talk;
  talk.hear_text(kCallText);
  talk.hear_text(kEndText);
  EXPECT_EQ(close_code(Conversation(talk).hear_message(1)), CloseCode::kProtocolError);
  EXPECT_EQ(close_code(Conversation(talk).hear_text(kEndText)), CloseCode::kProtocolError);
  EXPECT_TRUE(is<CancelCall>(talk.hear_text(kCancelText)));
}

TEST(Conversation, ACancelledCallDropsWhatComesUntilItsEnd) {
  Conversation talk;
  talk.hear_text(kCallText);
  EXPECT_TRUE(is<CancelCall>(talk.hear_text(kCancelText)));
  EXPECT_TRUE(talk.is_calling());
  EXPECT_TRUE(is<DropFrame>(talk.hear_message(1)));
  EXPECT_TRUE(is<DropFrame>(talk.hear_text(kEndText)));
  EXPECT_TRUE(is<DropFrame>(talk.hear_text(kCancelText)));
  EXPECT_TRUE(is<CloseSocket>(talk.hear_text(kCallText)));
}

TEST(Conversation, AMessageAboveTheLimitClosesTheSocketWithTheLimit) {
  Conversation talk;
  talk.hear_text(kCallText);
  EXPECT_EQ(close_code(Conversation(talk).hear_message(513, 512)), CloseCode::kTooBig);
  const Order order = talk.hear_message(kWebMessageBytesMax + 1);
  EXPECT_EQ(close_code(order), CloseCode::kTooBig);
  EXPECT_THAT(std::get<CloseSocket>(order).reason, HasSubstr("16777216"));
}

TEST(Conversation, AReasonFitsIntoACloseFrame) {
  const Order order = Conversation().hear_text(std::string(100'000, 'x'));
  EXPECT_LE(std::get<CloseSocket>(order).reason.size(), 123u);
}

}  // namespace
}  // namespace burnish

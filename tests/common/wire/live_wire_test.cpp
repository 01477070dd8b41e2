#include "common/wire/live_wire.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The fields of the message, and of those in it, that are not set: none but other members of a
/// oneof must be missing, so that no field is forgotten in both directions.
std::vector<std::string> unset_fields(const google::protobuf::Message& message) {
  std::vector<std::string> unset;
  const auto& reflection = *message.GetReflection();
  const auto visit = [&unset](const google::protobuf::Message& part) {
    for (std::string& name : unset_fields(part)) unset.push_back(std::move(name));
  };
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const auto& field = *message.GetDescriptor()->field(i);
    const bool is_set = field.is_repeated() ? reflection.FieldSize(message, &field) > 0
                                            : reflection.HasField(message, &field);
    if (!is_set && !field.real_containing_oneof()) unset.push_back(field.full_name());
    if (!is_set || field.cpp_type() != field.CPPTYPE_MESSAGE) continue;
    if (!field.is_repeated()) visit(reflection.GetMessage(message, &field));
    for (int n = 0; field.is_repeated() && n < reflection.FieldSize(message, &field); ++n)
      visit(reflection.GetRepeatedMessage(message, &field, n));
  }
  return unset;
}

ClientMessage returned(const ClientMessage& message) {
  return from_wire(to_wire(message)).value();
}

ServerMessage returned(const ServerMessage& message) {
  return from_wire(to_wire(message)).value().value();
}

/// Needs: no field has its default value.
template <typename Message>
void expect_unchanged(const Message& message) {
  const auto wire = to_wire(message);
  const Message back = returned(message);
  EXPECT_EQ(back.index(), message.index());
  EXPECT_EQ(to_wire(back).DebugString(), wire.DebugString());
  EXPECT_THAT(unset_fields(wire), ElementsAre());
}

Stroke stroke() {
  return {
      {.radius = 0.5, .strength = 0.75, .beta = 2, .fall_off = FallOff::kLinear, .connected = true},
      {Vec3d(1, 2, 3), Vec3d(-4, 5e-9, 6)}};
}

TransferCurve curve() {
  return *TransferCurve::create({{-20, 5}, {7.25, 100}});
}

TEST(LiveWire, EveryMessageOfTheClientComesBackUnchanged) {
  expect_unchanged<ClientMessage>(Greeting{"work", PageFrameKind::kVertices});
  expect_unchanged<ClientMessage>(FrameCredit{2, {7, 8}, {9}, true, 4096});
  expect_unchanged<ClientMessage>(ApplyEdits{{{"a", SetGradientScale{0.25}}, {"b", stroke()}}});
  expect_unchanged<ClientMessage>(Preview{"drag", SetGradientScale{0.25}});
  expect_unchanged<ClientMessage>(Preview{"drag", SetTransferCurve{curve()}});
  expect_unchanged<ClientMessage>(Preview{"drag", stroke()});
  expect_unchanged<ClientMessage>(DropPreview{"drag"});
  expect_unchanged<ClientMessage>(MoveBrush{BrushRing{Vec3d(1, 2, 3), 0.5}});
  expect_unchanged<ClientMessage>(Preview{"p", SetEqualiser{{{{0.5, 2}}}}});
  expect_unchanged<ClientMessage>(Preview{"p", SetPalette{{{{"letters", 0xd04040, curve()}}}}});
  expect_unchanged<ClientMessage>(Preview{"p", SetColour{{7, 0.25}}});
  expect_unchanged<ClientMessage>(Preview{"p", SetTexture{{2, 0.5, 0.25}}});
  expect_unchanged<ClientMessage>(Preview{"p", SetEdges{{0.5, NormalFilterKind::kEdges, 40, 7}}});
  expect_unchanged<ClientMessage>(Heartbeat{123456789});
  expect_unchanged<ClientMessage>(ShowPages{3, {7, 8}, {9}});
}

TEST(LiveWire, EveryMessageOfTheServerComesBackUnchanged) {
  const SessionInfo session{"id", "work", std::string(64, 'a'), {8, 0.01}, 17, 3, true};
  const FrameStats stats{true, true, 12, 3.5, 1e-4, 1e-6, 9, 1.5, 2.5, 3.5, 99, 4, 0.25, 0.5};
  const SessionPeople people{SessionRoles({{"ann", SessionRole::kOwner}}),
                             {{3, "ann", 0xE69F00, BrushRing{Vec3d(1, 2, 3), 0.5}}}};
  expect_unchanged<ServerMessage>(ProgressReport{"reading the journal", 0.5});
  expect_unchanged<ServerMessage>(
      Welcome{session, 7, SessionRole::kEditor, 0xfeed, "cpu", {"a:7411", "b:7411"}});
  expect_unchanged<ServerMessage>(LiveFrame{std::string("\0\xff bytes", 8), stats});
  expect_unchanged<ServerMessage>(EditsAcknowledged{{"a", "b"}, {1, 2, 3, {4, 5}}});
  expect_unchanged<ServerMessage>(EditsRefused{{"a", "b"}, unavailable("later")});
  expect_unchanged<ServerMessage>(HistoryState{3,
                                               {0.5,
                                                curve(),
                                                {true, 0.25, true},
                                                {{{0.5, 2}}},
                                                {{{"letters", 0xd04040, curve()}}},
                                                {7, 0.25},
                                                {0.5, NormalFilterKind::kEdges, 40, 7, 0.25},
                                                {2, 0.5, 0.25}}});
  expect_unchanged<ServerMessage>(people);
  expect_unchanged<ServerMessage>(Heartbeat{123456789});
  for (int code = 1; code <= static_cast<int>(GoAwayCode::kNotOwner); ++code)
    expect_unchanged<ServerMessage>(GoAway{
        static_cast<GoAwayCode>(code), "so", true, ServerPlace{"two:7411", "two"}, {"b:7411"}});
}

TEST(LiveWire, AGoAwayNamesTheServerBehindAProxyOrNone) {
  const auto place_after = [](const GoAway& go_away) {
    return std::get<GoAway>(returned(go_away)).moved_to;
  };
  const ServerPlace behind_a_proxy{"", "two"};
  EXPECT_EQ(place_after({GoAwayCode::kGoingDown, "so", true, behind_a_proxy}), behind_a_proxy);
  EXPECT_EQ(place_after({GoAwayCode::kGoingDown, "so", true}), std::nullopt);
}

TEST(LiveWire, ACodeOfANewerServersGoAwayIsUnknown) {
  v1::ServerMessage message;
  message.mutable_go_away()->set_code(static_cast<v1::GoAwayCode>(99));
  const auto go_away = std::get<GoAway>(from_wire(message).value().value());
  EXPECT_EQ(go_away.code, GoAwayCode::kUnknown);
}

TEST(LiveWire, ValuesArriveInTheirOwnFields) {
  const auto credit = std::get<FrameCredit>(returned(FrameCredit{2, {7, 8}, {9}, true, 4096}));
  EXPECT_EQ(credit.frames, 2u);
  EXPECT_THAT(credit.decoded, ElementsAre(7, 8));
  EXPECT_THAT(credit.refused, ElementsAre(9));
  EXPECT_EQ(credit.frame_bytes, 4096u);
  FrameStats stats;
  stats.residual = 1e-4;
  stats.held_ms = 2;
  stats.volume = 0.75;
  const auto frame = std::get<LiveFrame>(returned(LiveFrame{"data", stats}));
  EXPECT_EQ(frame.data, "data");
  EXPECT_FALSE(frame.stats.settled);
  EXPECT_EQ(frame.stats.residual, 1e-4);
  EXPECT_EQ(frame.stats.held_ms, 2);
  EXPECT_EQ(frame.stats.volume, 0.75);
}

TEST(LiveWire, NothingIsKeptApartFromZero) {
  EXPECT_FALSE(std::get<Greeting>(returned(Greeting{"work"})).kind.has_value());
  EXPECT_EQ(std::get<Greeting>(returned(Greeting{"w", PageFrameKind::kCorners})).kind,
            PageFrameKind::kCorners);
  EXPECT_FALSE(std::get<MoveBrush>(returned(MoveBrush{})).ring.has_value());
}

TEST(LiveWire, AGreetingSaysWhetherTheClientKnowsHeldVertices) {
  EXPECT_TRUE(std::get<Greeting>(returned(Greeting{"work"})).knows_held);
  EXPECT_FALSE(std::get<Greeting>(returned(Greeting{"work", {}, false})).knows_held);
}

std::string refusal(const v1::ClientMessage& message) {
  const auto said = from_wire(message);
  if (said.is_ok()) return "accepted";
  EXPECT_EQ(said.status().code(), StatusCode::kInvalidArgument);
  return said.status().message();
}

std::string refusal(const v1::ServerMessage& message) {
  const auto said = from_wire(message);
  if (said.is_ok()) return "accepted";
  EXPECT_EQ(said.status().code(), StatusCode::kInvalidArgument);
  return said.status().message();
}

TEST(LiveWire, AClientsMessageThatSaysNothingIsRefused) {
  EXPECT_THAT(refusal(v1::ClientMessage()), HasSubstr("says nothing"));
}

TEST(LiveWire, AGreetingAsksForAKindThatThereIs) {
  v1::ClientMessage message = to_wire(ClientMessage(Greeting{"work"}));
  message.mutable_greeting()->set_kind(static_cast<v1::FrameKind>(3));
  EXPECT_THAT(refusal(message), HasSubstr("frame kind 3 is none of 0"));
}

TEST(LiveWire, AClientThatDoesNotKnowPagesIsTold) {
  v1::ClientMessage message = to_wire(ClientMessage(Greeting{"work"}));
  message.mutable_greeting()->set_pages(false);
  const auto said = from_wire(message);
  EXPECT_EQ(said.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(said.status().message(), HasSubstr("a newer client"));
}

TEST(LiveWire, AChangeNamesAsManyPagesAsAClientMayShow) {
  ShowPages change{1, std::vector<PageId>(kShownPagesMax), {}};
  EXPECT_EQ(refusal(to_wire(ClientMessage(change))), "accepted");
  change.removed.resize(kShownPagesMax + 1);
  EXPECT_THAT(refusal(to_wire(ClientMessage(change))),
              HasSubstr("removes 4097, the limit is 4096"));
}

TEST(LiveWire, ACreditNames256FramesOfAKindAtMost) {
  for (const bool is_refused : {false, true}) {
    v1::ClientMessage message;
    auto& names = is_refused ? *message.mutable_credit()->mutable_refused()
                             : *message.mutable_credit()->mutable_decoded();
    names.Resize(256, 1);
    EXPECT_EQ(refusal(message), "accepted");
    names.Add(1);
    EXPECT_THAT(refusal(message), HasSubstr("257"));
    EXPECT_THAT(refusal(message), HasSubstr("256"));
  }
}

TEST(LiveWire, AMessageHas1To64EditsAndEachIsChecked) {
  v1::ClientMessage message;
  EXPECT_THAT((message.mutable_apply(), refusal(message)), HasSubstr("1 to 64 edits, not 0"));
  for (int i = 0; i < 64; ++i)
    *message.mutable_apply()->add_edits() =
        to_wire(ApplyEdits{{{std::to_string(i), SetGradientScale{1}}}}).apply().edits(0);
  EXPECT_EQ(refusal(message), "accepted");
  message.mutable_apply()->mutable_edits(63)->mutable_gradient_scale()->set_beta(kNan);
  EXPECT_THAT(refusal(message), HasSubstr("edit 63"));
  message.mutable_apply()->add_edits();
  EXPECT_THAT(refusal(message), HasSubstr("not 65"));
}

TEST(LiveWire, APreviewIsCheckedAsTheEditThatFollows) {
  v1::ClientMessage message;
  v1::Preview& preview = *message.mutable_preview();
  EXPECT_THAT(refusal(message), HasSubstr("0 bytes"));
  preview.set_edit_id("drag");
  EXPECT_THAT(refusal(message), HasSubstr("edit drag: it changes nothing"));
  for (const double beta : {kNan, kInfinity, -0.1, 10.5}) {
    preview.mutable_gradient_scale()->set_beta(beta);
    EXPECT_THAT(refusal(message), HasSubstr("outside 0..10"));
  }
  preview.mutable_transfer_curve();
  EXPECT_THAT(refusal(message), HasSubstr("1 to 64 points"));
  *preview.mutable_stroke() = to_wire(Preview{"drag", stroke()}).preview().stroke();
  EXPECT_EQ(refusal(message), "accepted");
  preview.mutable_stroke()->mutable_path(1)->set_z(kNan);
  EXPECT_THAT(refusal(message), HasSubstr("point 2"));
}

TEST(LiveWire, ARingIsFiniteAndHasARadius) {
  const auto ring = [](double x, double radius) {
    return refusal(to_wire(MoveBrush{BrushRing{Vec3d(x, 0, 0), radius}}));
  };
  EXPECT_EQ(ring(1, 0.5), "accepted");
  for (const double wrong : {kNan, kInfinity, 1e19}) {
    EXPECT_THAT(ring(wrong, 0.5), HasSubstr("within 1e18"));
    EXPECT_THAT(ring(0, wrong), HasSubstr("within 1e18"));
  }
  EXPECT_THAT(ring(0, 0), HasSubstr("radius 0 has"));
}

TEST(LiveWire, ARefusalNamesTheIdsThatAreNotTooLong) {
  v1::ClientMessage message;
  for (const size_t size : {1, 64, 65})
    message.mutable_apply()->add_edits()->set_id(std::string(size, 'x'));
  EXPECT_THAT(refused_ids(message), ElementsAre("x", std::string(64, 'x')));
  message.mutable_apply()->clear_edits();
  for (int i = 0; i < 100; ++i) message.mutable_apply()->add_edits()->set_id("e");
  EXPECT_EQ(refused_ids(message).size(), 64u);
  message.mutable_preview()->set_edit_id("drag");
  EXPECT_THAT(refused_ids(message), ElementsAre("drag"));
  message.mutable_preview()->set_edit_id(std::string(65, 'x'));
  EXPECT_THAT(refused_ids(message), ElementsAre());
}

TEST(LiveWire, AServersMessageOfAnUnknownKindIsPassedOver) {
  v1::ServerMessage message;
  ASSERT_TRUE(message.ParseFromString("\xa2\x06\x01x"));  // field 100, of a newer server
  const auto said = from_wire(message);
  ASSERT_TRUE(said.is_ok());
  EXPECT_FALSE(said->has_value());
}

TEST(LiveWire, AWelcomeSaysWhoTheClientIs) {
  v1::ServerMessage message = to_wire(Welcome{{}, 7, SessionRole::kEditor, 1, "cpu"});
  EXPECT_EQ(refusal(message), "accepted");
  v1::Welcome& welcome = *message.mutable_welcome();
  welcome.set_role(static_cast<v1::Role>(4));
  EXPECT_THAT(refusal(message), HasSubstr("role 4"));
  welcome.mutable_session()->set_depth(13);
  EXPECT_THAT(refusal(message), HasSubstr("depth 13"));
}

TEST(LiveWire, TheServersCurvesAndRolesAreChecked) {
  v1::ServerMessage message = to_wire(HistoryState{3, 0.5, curve()});
  message.mutable_history()->mutable_transfer_curve()->mutable_points(0)->set_kappa(kNan);
  EXPECT_THAT(refusal(message), HasSubstr("curve point 1"));
  message.mutable_people()->add_roles();
  EXPECT_THAT(refusal(message), HasSubstr("role 0"));
}

TEST(LiveWire, ARefusalIsNeverOk) {
  v1::ServerMessage message;
  for (const int code : {0, 2, 99}) {
    message.mutable_refused()->set_code(code);
    EXPECT_EQ(std::get<EditsRefused>(from_wire(message).value().value()).status.code(),
              StatusCode::kInternal);
  }
}

TEST(LiveWire, AnUnknownSolveStateIsNotSettled) {
  v1::ServerMessage message;
  message.mutable_frame()->set_state(static_cast<v1::SolveState>(9));
  EXPECT_FALSE(std::get<LiveFrame>(from_wire(message).value().value()).stats.settled);
}

}  // namespace
}  // namespace burnish

#include <random>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/unknown_field_set.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "core/burnish/v1/editing.pb.h"
#include "core/burnish/v1/library.pb.h"

// The classes of the browser's core are in the namespace `core`; protobuf's own say what is right.

namespace burnish {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using Random = std::mt19937;

int below(int limit, Random& random) {
  return std::uniform_int_distribution(0, limit - 1)(random);
}

/// Returns a number of 64 bits: often a limit.
uint64_t any_bits(Random& random) {
  static constexpr uint64_t kLimits[] = {
      0, 1, 127, 128, uint64_t(-1), 0x7fffffff, 0x80000000, 0xffffffff, 1ull << 63};
  if (below(2, random) == 0) return kLimits[below(std::size(kLimits), random)];
  return std::uniform_int_distribution<uint64_t>()(random);
}

std::string any_text(Random& random) {
  static const std::string kParts[] = {"", "a", "ä", "\xf0\x9f\x97\xbf", std::string("\0", 1)};
  std::string text;
  for (int n = below(4, random); n > 0; --n) text += kParts[below(std::size(kParts), random)];
  return text;
}

void fill(google::protobuf::Message& message, Random& random);

/// Sets a field, or adds to it, by Set##Name or Add##Name of protobuf's reflection.
#define BURNISH_PUT(Name, value)                                       \
  (field.is_repeated() ? reflection.Add##Name(&message, &field, value) \
                       : reflection.Set##Name(&message, &field, value))

void put(google::protobuf::Message& message, const FieldDescriptor& field, Random& random) {
  const auto& reflection = *message.GetReflection();
  const uint64_t bits = any_bits(random);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return BURNISH_PUT(Int32, static_cast<int32_t>(bits));
    case FieldDescriptor::CPPTYPE_INT64:
      return BURNISH_PUT(Int64, static_cast<int64_t>(bits));
    case FieldDescriptor::CPPTYPE_UINT32:
      return BURNISH_PUT(UInt32, static_cast<uint32_t>(bits));
    case FieldDescriptor::CPPTYPE_UINT64:
      return BURNISH_PUT(UInt64, bits);
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return BURNISH_PUT(Double, std::bit_cast<double>(bits));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return BURNISH_PUT(Float, std::bit_cast<float>(static_cast<uint32_t>(bits)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return BURNISH_PUT(Bool, bits % 2 == 1);
    case FieldDescriptor::CPPTYPE_ENUM:
      return BURNISH_PUT(EnumValue, static_cast<int>(bits));
    case FieldDescriptor::CPPTYPE_STRING:
      return BURNISH_PUT(String, any_text(random));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return fill(*(field.is_repeated() ? reflection.AddMessage(&message, &field)
                                        : reflection.MutableMessage(&message, &field)),
                  random);
  }
}

#undef BURNISH_PUT

void fill(google::protobuf::Message& message, Random& random) {
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    for (int n = below(field.is_repeated() ? 4 : 2, random); n > 0; --n)
      put(message, field, random);
  }
}

/// Damages bytes: changes, drops or doubles some of them.
std::string damaged(std::string bytes, Random& random) {
  for (int n = 1 + below(3, random); n > 0 && !bytes.empty(); --n) {
    const auto at = static_cast<size_t>(below(static_cast<int>(bytes.size()), random));
    const auto count = static_cast<size_t>(1 + below(4, random));
    switch (below(3, random)) {
      case 0:
        bytes[at] = static_cast<char>(below(256, random));
        break;
      case 1:
        bytes.erase(at, count);
        break;
      default:
        bytes.insert(at, bytes.substr(at, count));
    }
  }
  return bytes;
}

bool has_group(const google::protobuf::UnknownFieldSet& fields) {
  for (int i = 0; i < fields.field_count(); ++i)
    if (fields.field(i).type() == google::protobuf::UnknownField::TYPE_GROUP) return true;
  return false;
}

/// A group in the message or in one of its messages.
bool has_group(const google::protobuf::Message& message) {
  const auto& reflection = *message.GetReflection();
  if (has_group(reflection.GetUnknownFields(message))) return true;
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    if (!field->is_repeated() && has_group(reflection.GetMessage(message, field))) return true;
    for (int n = 0; field->is_repeated() && n < reflection.FieldSize(message, field); ++n)
      if (has_group(reflection.GetRepeatedMessage(message, field, n))) return true;
  }
  return false;
}

/// Reads bytes and writes what was read. None: they are refused.
template <typename Message>
std::optional<std::string> rewritten(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes)) return std::nullopt;
  return message.SerializeAsString();
}

template <typename Message>
std::optional<std::string> rewritten_by_protobuf(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes) || has_group(message)) return std::nullopt;
  message.DiscardUnknownFields();
  return message.SerializeAsString();
}

/// A message that goes over the wire by itself.
struct Root {
  std::string name;
  std::unique_ptr<google::protobuf::Message> (*make)();
  std::optional<std::string> (*rewritten)(const std::string&);
  std::optional<std::string> (*rewritten_by_protobuf)(const std::string&);
};

template <typename Protobuf, typename Core>
Root root(const char* name) {
  return {
      name,
      []() -> std::unique_ptr<google::protobuf::Message> { return std::make_unique<Protobuf>(); },
      rewritten<Core>, rewritten_by_protobuf<Protobuf>};
}

#define BURNISH_ROOT(Name) root<v1::Name, core::Name>(#Name)

/// Questions and answers of all calls.
const std::vector<Root>& roots() {
  static const std::vector<Root> roots = {BURNISH_ROOT(ImportRequest),
                                          BURNISH_ROOT(ImportEvent),
                                          BURNISH_ROOT(ListScansRequest),
                                          BURNISH_ROOT(ListScansResponse),
                                          BURNISH_ROOT(DescribeScanRequest),
                                          BURNISH_ROOT(ScanDescription),
                                          BURNISH_ROOT(PrepareScanRequest),
                                          BURNISH_ROOT(PrepareEvent),
                                          BURNISH_ROOT(DescribePagesRequest),
                                          BURNISH_ROOT(DescribePagesEvent),
                                          BURNISH_ROOT(FetchPagesRequest),
                                          BURNISH_ROOT(FetchPagesEvent),
                                          BURNISH_ROOT(DescribeSheetsRequest),
                                          BURNISH_ROOT(DescribeSheetsEvent),
                                          BURNISH_ROOT(FetchSheetsRequest),
                                          BURNISH_ROOT(FetchSheetsEvent),
                                          BURNISH_ROOT(ProposeEdgesRequest),
                                          BURNISH_ROOT(ProposeEdgesEvent),
                                          BURNISH_ROOT(RenameScanRequest),
                                          BURNISH_ROOT(ScanInfo),
                                          BURNISH_ROOT(SetScanUnitRequest),
                                          BURNISH_ROOT(DeleteScanRequest),
                                          BURNISH_ROOT(DeleteScanResponse),
                                          BURNISH_ROOT(OpenSessionRequest),
                                          BURNISH_ROOT(OpenSessionResponse),
                                          BURNISH_ROOT(ListSessionsRequest),
                                          BURNISH_ROOT(ListSessionsResponse),
                                          BURNISH_ROOT(CloseSessionRequest),
                                          BURNISH_ROOT(CloseSessionResponse),
                                          BURNISH_ROOT(RenameSessionRequest),
                                          BURNISH_ROOT(SessionInfo),
                                          BURNISH_ROOT(DeleteSessionRequest),
                                          BURNISH_ROOT(DeleteSessionResponse),
                                          BURNISH_ROOT(ApplyRequest),
                                          BURNISH_ROOT(ApplyResponse),
                                          BURNISH_ROOT(UploadCellFieldsRequest),
                                          BURNISH_ROOT(GetHistoryRequest),
                                          BURNISH_ROOT(GetHistoryResponse),
                                          BURNISH_ROOT(ForkSessionRequest),
                                          BURNISH_ROOT(ForkSessionResponse),
                                          BURNISH_ROOT(GetPeopleRequest),
                                          BURNISH_ROOT(People),
                                          BURNISH_ROOT(SetRoleRequest),
                                          BURNISH_ROOT(SetRoleResponse),
                                          BURNISH_ROOT(GetStateRequest),
                                          BURNISH_ROOT(SessionState),
                                          BURNISH_ROOT(ClientMessage),
                                          BURNISH_ROOT(ServerMessage),
                                          BURNISH_ROOT(WatchRequest),
                                          BURNISH_ROOT(GetCellsRequest),
                                          BURNISH_ROOT(Chunk),
                                          BURNISH_ROOT(GetPageValuesRequest),
                                          BURNISH_ROOT(PageValues),
                                          BURNISH_ROOT(GetDeviationRequest),
                                          BURNISH_ROOT(Deviation),
                                          BURNISH_ROOT(GetSectionRequest),
                                          BURNISH_ROOT(Section),
                                          BURNISH_ROOT(ExportRequest),
                                          BURNISH_ROOT(ExportEvent)};
  return roots;
}

#undef BURNISH_ROOT

void add_parts(const Descriptor& message, std::set<std::string>& names) {
  if (!names.insert(message.name()).second) return;
  for (int i = 0; i < message.field_count(); ++i)
    if (const Descriptor* part = message.field(i)->message_type()) add_parts(*part, names);
}

TEST(Messages, OfAllKindsAreTriedHere) {
  std::set<std::string> tried;
  for (const Root& root : roots()) add_parts(*root.make()->GetDescriptor(), tried);
  for (const auto* file : {v1::Chunk::descriptor()->file(), v1::ScanInfo::descriptor()->file(),
                           v1::Edit::descriptor()->file()})
    for (int i = 0; i < file->message_type_count(); ++i)
      EXPECT_TRUE(tried.contains(file->message_type(i)->name())) << file->message_type(i)->name();
}

TEST(Messages, HaveTheBytesThatProtobufWrites) {
  Random random(1);
  for (const Root& root : roots()) {
    for (int round = 0; round < 50; ++round) {
      const auto message = root.make();
      fill(*message, random);
      const std::string bytes = message->SerializeAsString();
      EXPECT_EQ(root.rewritten(bytes), bytes) << root.name << " " << message->DebugString();
    }
  }
}

TEST(Messages, ReadDamagedBytesAsProtobufDoesAndRefuseWhatItRefuses) {
  google::protobuf::SetLogHandler(nullptr);  // else it logs a line for each text that is not UTF-8
  Random random(2);
  for (const Root& root : roots()) {
    for (int round = 0; round < 2000; ++round) {
      const auto message = root.make();
      fill(*message, random);
      const std::string bytes = damaged(message->SerializeAsString(), random);
      EXPECT_EQ(root.rewritten(bytes), root.rewritten_by_protobuf(bytes))
          << root.name << " " << testing::PrintToString(bytes);
    }
  }
}

TEST(Messages, AFieldThatIsNotThereHasItsDefault) {
  const core::Edit edit;
  EXPECT_EQ(edit.id(), "");
  EXPECT_FALSE(edit.has_stroke());
  EXPECT_EQ(edit.change_case(), core::Edit::CHANGE_NOT_SET);
  EXPECT_EQ(edit.stroke().brush().radius(), 0);
  EXPECT_EQ(edit.stroke().path_size(), 0);
  EXPECT_EQ(edit.SerializeAsString(), "");
}

TEST(Messages, TheLastMemberOfAOneofIsTheOneThatIsThere) {
  core::Edit edit;
  edit.mutable_stroke()->mutable_brush()->set_radius(2);
  edit.mutable_gradient_scale()->set_beta(0.5);
  EXPECT_FALSE(edit.has_stroke());
  EXPECT_EQ(edit.change_case(), core::Edit::kGradientScale);
  EXPECT_EQ(edit.gradient_scale().beta(), 0.5);
  EXPECT_EQ(edit.stroke().brush().radius(), 0);
}

TEST(Messages, AMemberOfAOneofWithTheDefaultOfItsTypeIsThere) {
  core::Brush brush;
  brush.set_colour(false);
  EXPECT_TRUE(brush.has_colour());
  core::Brush back;
  ASSERT_TRUE(back.ParseFromString(brush.SerializeAsString()));
  EXPECT_EQ(back.paints_case(), core::Brush::kColour);
}

TEST(Messages, ACopyIsAPartOfNothingAndAMovedMessageIsEmpty) {
  core::Stroke stroke;
  stroke.add_path()->set_x(1);
  core::Stroke copy = stroke;
  stroke.add_path()->set_x(2);
  EXPECT_EQ(copy.path_size(), 1);
  EXPECT_EQ(copy.path(0).x(), 1);
  copy = std::move(stroke);
  EXPECT_EQ(copy.path_size(), 2);
  copy = *&copy;
  EXPECT_EQ(copy.path(1).x(), 2);
}

TEST(Messages, ReadingTakesThePlaceOfAllFields) {
  core::RenameSessionRequest request;
  request.set_session("a");
  request.set_name("b");
  core::RenameSessionRequest other;
  other.set_name("c");
  ASSERT_TRUE(request.ParseFromString(other.SerializeAsString()));
  EXPECT_EQ(request.session(), "");
  EXPECT_EQ(request.name(), "c");
}

}  // namespace
}  // namespace burnish

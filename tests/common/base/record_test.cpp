#include "common/base/record.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

struct Key {
  int depth = 0;
};
BURNISH_RECORD(Key, depth)

struct Thing {
  std::string name;
  Key key;
  std::vector<int> marks;
  double hidden = 0;  // not in the list
};
BURNISH_RECORD(Thing, name, key, marks)

/// A message with the fields of Thing, as protobuf makes it.
class ThingMessage {
 public:
  const std::string& name() const { return name_; }
  int depth() const { return depth_; }
  const std::vector<int>& marks() const { return marks_; }
  void set_name(const std::string& name) { name_ = name; }
  void set_depth(int depth) { depth_ = depth; }
  void add_marks(int mark) { marks_.push_back(mark); }

 private:
  std::string name_;
  int depth_ = 0;
  std::vector<int> marks_;
};

TEST(Record, FieldsComeInTheOrderOfTheListAndThoseOfAPartBetweenThem) {
  std::string names;
  const Thing thing;
  visit_fields(thing, [&](const std::string& name, const auto&) { names += name + " "; });
  EXPECT_EQ(names, "name depth marks ");
}

TEST(Record, AMessageBringsEveryFieldOfTheListBack) {
  ThingMessage message;
  message.set_name("another");
  write_fields(Thing{"cup", {7}, {1, 2}, 5}, message);
  const auto read = read_record<Thing>(message);
  EXPECT_EQ(read.name, "cup");
  EXPECT_EQ(read.key.depth, 7);
  EXPECT_EQ(read.marks, (std::vector<int>{1, 2}));
  EXPECT_EQ(read.hidden, 0);
}

static_assert(Record<Key> && !Record<std::string> && !Record<int>);
static_assert(RepeatedField<std::vector<int>> && !RepeatedField<std::string>);

}  // namespace
}  // namespace burnish

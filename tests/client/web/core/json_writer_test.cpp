#include "client/web/core/json_writer.h"

#include <limits>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(JsonWriter, MembersAndItemsAreSeparated) {
  JsonWriter json;
  json.open().text("a", "x").whole("b", -3).key("c").open_list().number(0.5).flag(true).null();
  json.close_list().key("d").open().close().key("e").open_list().close_list().close();
  EXPECT_EQ(json.written(), R"({"a":"x","b":-3,"c":[0.5,true,null],"d":{},"e":[]})");
}

TEST(JsonWriter, TextsAreEscapedAndAlwaysUtf8) {
  JsonWriter json;
  json.text("q\"\\\n\x01ü\xff");
  EXPECT_EQ(json.written(), R"("q\"\\\\\u000a\u0001ü\\xff")");
}

TEST(JsonWriter, NumbersThatJsonDoesNotHaveBecomeZero) {
  JsonWriter json;
  json.open_list()
      .number(std::numeric_limits<double>::infinity())
      .number(std::nan(""))
      .close_list();
  EXPECT_EQ(json.written(), "[0,0]");
}

}  // namespace
}  // namespace burnish

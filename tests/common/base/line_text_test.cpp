#include "common/base/line_text.h"

#include <cstdint>
#include <sstream>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(LineText, WritesWhatAStreamOfThisPrecisionWrites) {
  for (const int digits : {6, 12, 17}) {
    LineText line(digits);
    std::ostringstream stream;
    stream.precision(digits);
    const auto write = [](auto& to) {
      to << "a" << ' ' << 0.1 << ' ' << 1e-9 << ' ' << 123456789.0 << ' ' << -0.0 << ' ' << 2.5f
         << ' ' << -7 << ' ' << UINT64_MAX << std::string(" b");
    };
    write(line);
    write(stream);
    EXPECT_EQ(line.text(), stream.str());
  }
}

}  // namespace
}  // namespace burnish

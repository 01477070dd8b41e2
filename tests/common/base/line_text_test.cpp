#include "common/base/line_text.h"

#include <cstdint>
#include <sstream>

#include <gtest/gtest.h>

#include "common/base/parse_number.h"

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

TEST(LineText, ExactNumbersHaveTheFewestDigitsThatReadBack) {
  for (const double value : {0.4, 1.0 / 3, 1e-300, -0.1f * 3.0, 2.5, 1e22, 4.0}) {
    LineText line(LineText::kExact);
    line << value;
    EXPECT_EQ(parse_number<double>(line.text()), value) << line.text();
  }
  EXPECT_EQ((LineText(LineText::kExact) << 0.4).text(), "0.4");
}

}  // namespace
}  // namespace burnish

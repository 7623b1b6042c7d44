#include "io/json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace autoref::io {
namespace {

TEST(Json, EscapesTexts) { EXPECT_EQ(json_text("a\"b\\c\n\x01"), R"("a\"b\\c\n\u0001")"); }

TEST(Json, ReplacesWhatIsNotUtf8) { EXPECT_EQ(json_text("a\xff"), "\"a\xef\xbf\xbd\""); }

TEST(Json, IsOneLineInTheOrderOfItsMembers) {
  EXPECT_EQ(json_text({{"z", {1, true, nullptr}}, {"a", Json::object()}}),
            R"({"z": [1, true, null], "a": {}})");
}

TEST(Json, WritesTheShortestNumberThatReadsBackEqual) {
  for (const double number : {0.1, 1.0 / 3, -2e-300, 5e-324, 1.7976931348623157e308, 123456789.0})
    EXPECT_EQ(Json::parse(json_text(number)).get<double>(), number);
  EXPECT_EQ(json_text(0.1), "0.1");
  EXPECT_EQ(json_text(2.0), "2");
}

TEST(Json, WritesNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(json_text(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(json_text(-std::numeric_limits<double>::infinity()), "null");
}

TEST(Json, RoundsToDecimals) {
  EXPECT_EQ(json_text(rounded(12.3456, 2)), "12.35");
  EXPECT_EQ(json_text(rounded(-0.75, 0)), "-1");
}

}  // namespace
}  // namespace autoref::io

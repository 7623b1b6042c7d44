#include "league/team/greeting.hpp"

#include <gtest/gtest.h>

#include <string>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

std::string fault_of(std::string_view bytes) {
  try {
    find_greeting(bytes);
  } catch (const TeamFault& fault) {
    return fault.what();
  }
  return "none";
}

TEST(Greeting, NamesTheEncodingAndTheMotion) {
  EXPECT_EQ(greeting_of("autoref-team 1 flat"),
            (Greeting{TeamEncoding::kFlat, TeamMotion::kTracked}));
  EXPECT_EQ(greeting_of("autoref-team 1 json tracked"),
            (Greeting{TeamEncoding::kJson, TeamMotion::kTracked}));
  EXPECT_EQ(greeting_of("autoref-team 1 flat detections"),
            (Greeting{TeamEncoding::kFlat, TeamMotion::kDetections}));
}

TEST(Greeting, AsksForDetectionsInTheLeaguesMessages) {
  EXPECT_EQ(greeting_of("autoref-team 1 league"),
            (Greeting{TeamEncoding::kLeague, TeamMotion::kDetections}));
  EXPECT_EQ(greeting_of("autoref-team 1 league tracked"),
            (Greeting{TeamEncoding::kLeague, TeamMotion::kTracked}));
}

TEST(Greeting, IsFoundOnceItsLineIsComplete) {
  const std::string line = "autoref-team 1 json\n";
  for (std::size_t size = 0; size < line.size(); ++size) {
    EXPECT_FALSE(find_greeting(line.substr(0, size)).has_value());
  }
  const auto found = find_greeting(line + "{\"frame\"");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->size, line.size());
  EXPECT_EQ(found->greeting.encoding, TeamEncoding::kJson);
}

TEST(Greeting, WithAnUnknownEncodingIsRefusedAndListsTheKnownOnes) {
  EXPECT_EQ(
      fault_of("autoref-team 1 protobuf\n"),
      "the first line is \"autoref-team 1 protobuf\": unknown encoding \"protobuf\"; expected "
      "\"autoref-team 1 ENCODING [MOTION]\", with ENCODING json, flat or league and MOTION "
      "tracked or detections");
}

struct WrongLine {
  const char* name;
  std::string bytes;
  std::string fault;
};

class WrongGreeting : public testing::TestWithParam<WrongLine> {};

TEST_P(WrongGreeting, IsRefusedInPlainWords) {
  const std::string fault = fault_of(GetParam().bytes);
  EXPECT_NE(fault.find(GetParam().fault), std::string::npos) << fault;
  EXPECT_NE(fault.find("expected \"autoref-team 1 ENCODING [MOTION]\""), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Of, WrongGreeting,
    testing::Values(
        WrongLine{"Empty", "\n", "the first line is \"\": it is not a greeting"},
        WrongLine{"Other", "hello\n", "\"hello\": it is not a greeting"},
        WrongLine{"NoVersion", "autoref-team\n", "the version is missing"},
        WrongLine{"Version", "autoref-team 2 json\n", "unknown version \"2\""},
        WrongLine{"NoEncoding", "autoref-team 1\n", "the encoding is missing"},
        WrongLine{"EncodingAndMore", "autoref-team 1 xml tracked\n", "unknown encoding \"xml\""},
        WrongLine{"Motion", "autoref-team 1 json all\n", "unknown motion \"all\""},
        WrongLine{"Words", "autoref-team 1 json tracked x\n", "it has too many words"},
        WrongLine{"TwoSpaces", "autoref-team  1 json\n", "unknown version \"\""},
        WrongLine{"CarriageReturn", "autoref-team 1 json\r\n", "unknown encoding \"json\\x0D\""},
        WrongLine{"Binary", "\x7F\xFF\n", "the first line is \"\\x7F\\xFF\""},
        WrongLine{"Endless", std::string(81, 'a'), "does not end within 80 bytes"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::league

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/short_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

using Xml = boost::property_tree::ptree;

// Throws if the text is not well-formed.
Xml xml_of(const std::string& text) {
  std::istringstream stream(text);
  Xml xml;
  read_xml(stream, xml);
  return xml;
}

// Counts the elements at any depth with this value of the attribute.
int count_of(const Xml& xml, const std::string& attribute, const std::string& value) {
  int count = xml.get("<xmlattr>." + attribute, "") == value ? 1 : 0;
  for (const auto& [name, child] : xml)
    if (name != "<xmlattr>") count += count_of(child, attribute, value);
  return count;
}

class DrawVerb : public testing::TestWithParam<const char*> {
 protected:
  Answer draw(std::vector<const char*> what) {
    std::vector<const char*> arguments = {"log", "draw", log_.c_str(), "-o", drawing_.c_str()};
    arguments.insert(arguments.end(), what.begin(), what.end());
    return answer_to(arguments);
  }

  TemporaryFolder folder_;
  std::string log_ = write_short_log(folder_, GetParam());
  std::string drawing_ = folder_ / "frame.svg";
};

TEST_P(DrawVerb, ShowsEveryRobotAndTheBallOnce) {
  const Answer answer = draw({"--at", "2.5"});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  const Xml xml = xml_of(content_of(drawing_));
  EXPECT_EQ(count_of(xml, "class", "robot"), 12);
  EXPECT_EQ(count_of(xml, "class", "ball"), 1);
}

TEST_P(DrawVerb, ShowsTimeAndScore) {
  draw({"--at", "2.5"});
  EXPECT_NE(content_of(drawing_).find(">2.50 s | basic (a) 0 : 0 basic (b) | "), std::string::npos);
}

TEST_P(DrawVerb, TracesAllPathsAndMarksTheirStarts) {
  const Answer answer = draw({"--trace", "0.5:3"});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  const Xml xml = xml_of(content_of(drawing_));
  EXPECT_EQ(count_of(xml, "class", "begin"), 13);
  EXPECT_EQ(count_of(xml, "class", "robot"), 12);
  EXPECT_GT(count_of(xml, "stroke-opacity", "1.00"), 0);
}

TEST_P(DrawVerb, NamesTheLogsRangeIfATimeIsOutside) {
  for (const auto& what : std::vector<std::vector<const char*>>{
           {"--at", "1000"}, {"--at", "-1"}, {"--trace", "5:100"}}) {
    const Answer answer = draw(what);
    EXPECT_EQ(answer.code, io::kBadInput) << what[1];
    EXPECT_NE(answer.err.find("is not in the log, which covers 0.000 to "), std::string::npos)
        << answer.err;
  }
  EXPECT_FALSE(std::filesystem::exists(drawing_));
}

TEST_P(DrawVerb, RefusesInvalidTimes) {
  for (const auto& what : std::vector<std::vector<const char*>>{
           {"--at", "soon"}, {"--trace", "5"}, {"--trace", "3:2"}, {"--trace", "0:1e9"}, {}}) {
    EXPECT_EQ(draw(what).code, io::kBadInput);
  }
}

INSTANTIATE_TEST_SUITE_P(Books, DrawVerb, testing::Values("paper", "2026-b"), [](const auto& book) {
  return std::string(book.param) == "paper" ? "RoundArea" : "BoxArea";
});

}  // namespace
}  // namespace autoref::app

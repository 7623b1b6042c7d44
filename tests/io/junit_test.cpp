#include "io/junit.hpp"

#include <gtest/gtest.h>

#include "tests/support/has_part.hpp"

namespace autoref::io {
namespace {

TEST(JunitXml, CountsFailuresAndErrors) {
  const std::string xml = junit_xml("s", {{"g", "good", TestOutcome::kPassed, "", ""},
                                          {"g", "bad", TestOutcome::kFailed, "m", "t\n"},
                                          {"g", "void", TestOutcome::kError, "e", ""}});
  EXPECT_TRUE(has(xml, "<testsuite name=\"s\" tests=\"3\" failures=\"1\" errors=\"1\"")) << xml;
  EXPECT_TRUE(has(xml, "<testcase classname=\"g\" name=\"good\">\n  </testcase>")) << xml;
  EXPECT_TRUE(has(xml, "<failure message=\"m\">t\n</failure>")) << xml;
  EXPECT_TRUE(has(xml, "<error message=\"e\"></error>")) << xml;
}

TEST(JunitXml, ShowsTheTextOfAPassedTest) {
  const std::string xml = junit_xml("s", {{"g", "n", TestOutcome::kPassed, "", "+0.4"}});
  EXPECT_TRUE(has(xml, "<system-out>+0.4</system-out>")) << xml;
}

TEST(JunitXml, EscapesMarkupAndLineBreaksInAttributes) {
  const std::string nasty = "a|<b> & \"c\" 'd' `e`\n\x01\xff]]>";
  const std::string xml = junit_xml(nasty, {{"g", "n", TestOutcome::kFailed, nasty, nasty}});
  const std::string escaped = "a|&lt;b&gt; &amp; &quot;c&quot; 'd' `e`";
  EXPECT_TRUE(has(xml, "name=\"" + escaped + "&#10;\uFFFD\uFFFD]]&gt;\"")) << xml;
  EXPECT_TRUE(has(xml, ">" + escaped + "\n\uFFFD\uFFFD]]&gt;</failure>")) << xml;
}

}  // namespace
}  // namespace autoref::io

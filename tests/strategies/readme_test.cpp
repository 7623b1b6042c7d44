// Tests that strategies/README.md matches the code.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/checkout.hpp"

namespace autoref::strategies {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(in_checkout(path));
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The text between the two marks.
std::string between(const std::string& text, const std::string& mark) {
  const std::size_t first = text.find(mark);
  const std::size_t from = first == std::string::npos ? first : first + mark.size();
  const std::size_t to = text.find(mark, from);
  if (from == std::string::npos || to == std::string::npos) return "no two marks " + mark;
  return text.substr(from, to - from);
}

TEST(StrategiesReadme, ShowsTheTeamThatIsPlayed) {
  const std::string code = between(text_of("tests/strategies/readme_team.hpp"), "// [mine]\n");
  EXPECT_NE(text_of("strategies/README.md").find("```cpp\n" + code + "```\n"), std::string::npos);
}

TEST(StrategiesReadme, ShowsThePlaybookThatIsPlayed) {
  const std::string code = between(text_of("tests/strategies/readme_team.hpp"), "// [bus]\n");
  EXPECT_NE(text_of("strategies/README.md").find("```cpp\n" + code + "```\n"), std::string::npos);
}

}  // namespace
}  // namespace autoref::strategies

// Texts that expand endlessly, or nearly so, are rejected before anything traverses them.
#include "io/yaml_text.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace autoref::io {
namespace {

std::string bounds_refusal_of(const std::string& text, const YamlBounds& bounds = {}) {
  const std::optional<BeyondBounds> beyond = beyond_bounds(text, bounds);
  if (!beyond) return "within bounds";
  return std::to_string(beyond->line) + ":" + std::to_string(beyond->column) + ": " +
         beyond->message;
}

// A "billion laughs" document, in which each line refers nine times to the line before.
std::string laughs(int lines) {
  std::string text = "a0: &a0 [ha]\n";
  for (int i = 1; i <= lines; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int copy = 0; copy < 9; ++copy) text += before + ", ";
    text += "ha]\n";
  }
  return text;
}

TEST(YamlBounds, RefuseAnAliasInsideTheValueItRefersTo) {
  for (const char* text : {"about: &x [*x]\n", "a: &x { b: *x }\n", "&x [1, [2, [*x]]]\n"}) {
    EXPECT_NE(bounds_refusal_of(text).find("write out what is meant instead"), std::string::npos)
        << text;
  }
  EXPECT_TRUE(bounds_refusal_of("schema: 1\nabout: &x [*x]\n").starts_with("2:12: this alias"));
}

TEST(YamlBounds, RefuseAliasesThatExpandToMillions) {
  EXPECT_EQ(bounds_refusal_of(laughs(4)), "within bounds");
  EXPECT_NE(bounds_refusal_of(laughs(9)).find("more than 200000 values"), std::string::npos);
  EXPECT_NE(bounds_refusal_of(laughs(25)).find("more than 200000 values"), std::string::npos);
}

TEST(YamlBounds, AllowOrdinaryAliases) {
  EXPECT_EQ(bounds_refusal_of("a: &fast { speed: 3 }\nb: *fast\nc: [*fast, *fast]\n"),
            "within bounds");
  EXPECT_EQ(bounds_refusal_of("a: &x 1\nb: *x\nc: &x [2]\nd: *x\n"),
            "within bounds");  // two anchors with the same name
}

TEST(YamlBounds, CountTheNodesOfAliases) {
  const YamlBounds five{.nodes = 5};
  EXPECT_EQ(bounds_refusal_of("[1, 2, 3, 4]\n", five), "within bounds");
  EXPECT_NE(bounds_refusal_of("[1, 2, 3, 4, 5]\n", five), "within bounds");
  EXPECT_EQ(bounds_refusal_of("[&x [1], *x]\n", five), "within bounds");
  EXPECT_NE(bounds_refusal_of("[&x [1], *x, *x]\n", five), "within bounds");
}

TEST(YamlBounds, RefuseDeepNestingInBracketsLinesAndAliases) {
  EXPECT_NE(bounds_refusal_of(std::string(100'000, '[')).find("more than 32 deep"),
            std::string::npos);
  const std::string close(33, ']');
  EXPECT_TRUE(
      bounds_refusal_of(std::string(33, '[') + close).starts_with("1:33: lists and mappings"));
  EXPECT_EQ(bounds_refusal_of(std::string(32, '[') + close.substr(1)), "within bounds");
  std::string dashes, aliases = "- &a0 [1]\n";
  for (int i = 0; i < 1000; ++i) dashes += "- ";
  for (int i = 1; i < 40; ++i)
    aliases += "- &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + "]\n";
  EXPECT_NE(bounds_refusal_of(dashes + "1\n").find("more than 32 deep"), std::string::npos);
  EXPECT_NE(bounds_refusal_of(aliases).find("more than 32 deep"), std::string::npos);
}

TEST(YamlBounds, RefuseHugeTextsAndHugeLists) {
  EXPECT_NE(
      bounds_refusal_of("a: " + std::string(70'000, 'x') + "\n").find("1:4: this text has 70000"),
      std::string::npos);
  EXPECT_NE(bounds_refusal_of(std::string(5'000'000, '#')).find("0:0: the text has 5000000 bytes"),
            std::string::npos);
  std::string list = "[";
  for (int i = 0; i < 300'000; ++i) list += "1,";
  EXPECT_NE(bounds_refusal_of(list + "1]\n").find("more than 200000 values"), std::string::npos);
}

TEST(YamlBounds, RefuseTextOnWhichTheParserWouldLoop) {
  for (const char* text : {", schema: 1\n", "}\n", "a: 1\n---\n, b\n", "] }\n"}) {
    std::string refusal;
    try {
      refusal = bounds_refusal_of(text);
    } catch (const YAML::Exception& error) {
      refusal = error.what();
    }
    EXPECT_NE(refusal, "within bounds") << text;
  }
  EXPECT_TRUE(bounds_refusal_of(", schema: 1\n").starts_with("1:1: no value begins like this"));
}

TEST(YamlBounds, LeaveInvalidTextToTheParser) {
  EXPECT_THROW(beyond_bounds("[1, 2\n"), YAML::Exception);
}

}  // namespace
}  // namespace autoref::io

#include "io/yaml_text.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace autoref::io {
namespace {

TEST(QuotedScalar, IsTheTextInQuotes) {
  EXPECT_EQ(quoted_scalar("a: b"), "\"a: b\"");
  EXPECT_EQ(quoted_scalar("say \"x\""), "\"say \\\"x\\\"\"");
}

TEST(QuotedScalar, ReadsBackEqual) {
  for (const char* text :
       {"", "null", "- a: {b}", "two\nlines # and\ttabs\r", "\x01\x7f", "Gegnergr\u00f6\u00dfe"})
    EXPECT_EQ(YAML::Load(quoted_scalar(text)).as<std::string>(), text);
}

}  // namespace
}  // namespace autoref::io

// The version is the same in every file that states it.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "io/build_id.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::stability {
namespace {

std::string version() {
  const std::string build(io::build_id());
  return build.substr(0, build.find('-'));
}

// The first part of a file that matches, such as "version: 1.0.0"; the version is in parentheses.
std::string stated_in(const std::string& file, const std::string& pattern) {
  const std::string text = content_of(in_checkout(file));
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "none";
}

TEST(Version, IsTheNewestOfTheChangelog) {
  EXPECT_EQ(stated_in("CHANGELOG.md", R"(\n## \[([0-9.]+)\] - \d{4}-\d\d-\d\d\n)"), version());
}

TEST(Version, IsThatOfThePythonPackage) {
  EXPECT_EQ(stated_in("python/pyproject.toml", "\nversion = \"([0-9.]+)\"\n"), version());
}

TEST(Version, IsCitedWithTheDateOfItsRelease) {
  EXPECT_EQ(stated_in("CITATION.cff", "\nversion: ([0-9.]+)\n"), version());
  EXPECT_EQ(stated_in("CITATION.cff", "\ndate-released: ([0-9-]+)\n"),
            stated_in("CHANGELOG.md", R"(\n## \[[0-9.]+\] - ([0-9-]+)\n)"));
}

}  // namespace
}  // namespace autoref::stability

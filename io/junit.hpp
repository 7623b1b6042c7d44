// Test results as JUnit XML, the format that GitLab, Jenkins and actions of GitHub read.
#pragma once

#include <string>
#include <vector>

namespace autoref::io {

enum class TestOutcome {
  kPassed,
  kFailed,  // the test checked something that is not so
  kError,   // something prevented the test, or went wrong besides
};

struct TestCase {
  std::string group;  // where the test belongs; servers list tests by it
  std::string name;
  TestOutcome outcome = TestOutcome::kPassed;
  std::string message = {};  // one line about a failure or an error
  std::string text = {};     // further lines, such as tables
};

// One suite with these cases. Texts may contain any characters: control characters that XML does
// not allow, and bytes that are not UTF-8, become U+FFFD.
std::string junit_xml(const std::string& suite, const std::vector<TestCase>& cases);

}  // namespace autoref::io

// Exit code and output of `autoref` for a command line.
#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace autoref::app {

struct Answer {
  int code = 0;
  std::string out;
  std::string err;
};

inline Answer answer_to(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "autoref");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Answer answer;
  answer.code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
  answer.out = testing::internal::GetCapturedStdout();
  answer.err = testing::internal::GetCapturedStderr();
  return answer;
}

// The same for a verb, for example "results status", and the words after it.
inline Answer answer_to(const std::string& verb, const std::vector<const char*>& more) {
  std::istringstream text(verb);
  std::vector<std::string> names{std::istream_iterator<std::string>(text), {}};
  std::vector<const char*> arguments;
  for (const std::string& name : names) arguments.push_back(name.c_str());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return answer_to(arguments);
}

}  // namespace autoref::app

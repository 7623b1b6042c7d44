// Exit code and output of `autoref` for a command line.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/program.hpp"

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

}  // namespace autoref::app

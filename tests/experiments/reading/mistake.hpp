// Scenario files that must be rejected.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {

struct Mistake {
  const char* name;
  std::string text;
  const char* start;                   // start of the message: file, line, column
  std::vector<const char*> fragments;  // parts of the message: key and remedy
};

inline void expect_refused(const Mistake& mistake) {
  try {
    read_scenario_text(mistake.text, "x.yaml");
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(mistake.start)) << message;
    for (const char* fragment : mistake.fragments) {
      EXPECT_NE(message.find(fragment), std::string::npos) << message << "\nlacks: " << fragment;
    }
  }
}

}  // namespace autoref::experiments

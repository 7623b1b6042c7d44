// The page of a recorded game with the calls of both referees.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "league/log_contents.hpp"
#include "logs/calls.hpp"
#include "view/page.hpp"

namespace autoref::logs {

// The calls of both referees in order of time.
std::vector<view::ComparedCall> compared_calls(const Agreement& agreement);

// `decisions` are AutoRef's, and `name` is what the user calls the log. Throws league::LogError.
std::string log_page(const std::filesystem::path& log, const std::string& name, const Field& field,
                     const std::vector<view::RecordedDecision>& decisions,
                     const Agreement& agreement,
                     league::FrameSource source = league::FrameSource::kFirst);

// The address of a moment in that page, such as "game.html#t=83.20".
std::string moment_in(const std::string& page, double time_s);

}  // namespace autoref::logs

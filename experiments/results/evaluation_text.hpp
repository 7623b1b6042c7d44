// A judged game's evaluation as the text of a cell in its row.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "experiments/results/call_evaluation.hpp"

namespace autoref::experiments {

// One line. Times and distances have four decimals.
std::string text_of(const CallEvaluation& evaluation);

// Returns nullopt if the text is not an evaluation.
std::optional<CallEvaluation> evaluation_in(std::string_view text);

}  // namespace autoref::experiments

#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (view.now.play != Play::kStop) return std::nullopt;
  return ActiveFoul{};
}

bool go_on(const RowdyView& view, ActiveFoul& /*foul*/, TeamOutput& output) {
  output.requests.timeout = true;
  return view.now.play == Play::kStop;
}

}  // namespace

const FoulBehaviour kTimeout = {"timeout", "Requests a timeout.", 0.005, 1, find_chance, go_on};

}  // namespace autoref::strategies::rowdy

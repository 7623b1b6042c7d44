// A robot drives an opponent back.
#include <algorithm>

#include "runner/judge/truth/outline.hpp"
#include "runner/judge/truth/truths.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::truth {
namespace {

constexpr double kMargin_m = 20_mm;
// A robot that drove away from the pusher itself faster than this was not pushed.
constexpr double kOwnWay_mps = 0.1_mps;
constexpr double kOwnMargin_mps = 0.1_mps;

// Two opponents in contact, since when and from where. First the west's robot.
struct Clinch {
  RobotId west;
  RobotId east;
  Vec2 west_from_m{0, 0};
  Vec2 east_from_m{0, 0};
  Vec2 west_mps{0, 0};  // in the frame before the contact
  Vec2 east_mps{0, 0};
  bool is_told = false;
  bool lasts = true;
};

class Pushing final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    if (!scene.play.is_on) {
      clinches_.clear();
      return;
    }
    for (Clinch& clinch : clinches_) clinch.lasts = false;
    for_each_robot(scene.now, Side::kWest, [&](RobotId west, const sim::RobotState& a) {
      for_each_robot(scene.now, Side::kEast, [&](RobotId east, const sim::RobotState& b) {
        if (are_in_contact(a, b)) judge(scene, clinch_of(scene, west, a, east, b), a, b, all);
      });
    });
    const auto over = [](const Clinch& clinch) { return !clinch.lasts; };
    clinches_.erase(std::remove_if(clinches_.begin(), clinches_.end(), over), clinches_.end());
  }

 private:
  Clinch& clinch_of(const Scene& scene, RobotId west, const sim::RobotState& a, RobotId east,
                    const sim::RobotState& b) {
    for (Clinch& clinch : clinches_) {
      if (clinch.west != west || clinch.east != east) continue;
      clinch.lasts = true;
      return clinch;
    }
    clinches_.push_back({west, east, a.position_m, b.position_m, a.velocity_mps, b.velocity_mps});
    // Who has just come onto the field was not there a frame ago.
    if (const sim::RobotState* before = find_robot(scene.before, west)) {
      clinches_.back().west_mps = before->velocity_mps;
    }
    if (const sim::RobotState* before = find_robot(scene.before, east)) {
      clinches_.back().east_mps = before->velocity_mps;
    }
    return clinches_.back();
  }

  static void judge(const Scene& scene, Clinch& clinch, const sim::RobotState& a,
                    const sim::RobotState& b, Happenings& all) {
    if (clinch.is_told) return;
    const Vec2 east_of = direction_of(b.position_m - a.position_m, Vec2(1.0, 0.0));
    const Vec2 a_way_m = a.position_m - clinch.west_from_m;
    const Vec2 b_way_m = b.position_m - clinch.east_from_m;
    const double way_m = std::min(a_way_m.dot(east_of), b_way_m.dot(east_of));
    const double back_m = std::min(-a_way_m.dot(east_of), -b_way_m.dot(east_of));
    const bool west_pushes = way_m > back_m;
    const double own_mps =
        west_pushes ? clinch.east_mps.dot(east_of) : -clinch.west_mps.dot(east_of);
    const double excess_m = std::max(way_m, back_m) - scene.rules.pushing_m;
    if (own_mps > kOwnWay_mps + kOwnMargin_mps || excess_m <= -kMargin_m) return;
    clinch.is_told = excess_m > 0;
    const RobotId pusher = west_pushes ? clinch.west : clinch.east;
    const Happening push{"pushing", scene.time_s, pusher.side, pusher,
                         Vec2((a.position_m + b.position_m) / 2.0)};
    const bool is_own_way = own_mps > kOwnWay_mps;
    add_measured(all, push, is_own_way ? -kMargin_m / 2 : excess_m, kMargin_m);
  }

  std::vector<Clinch> clinches_;
};

}  // namespace

std::unique_ptr<Truth> pushing() { return std::make_unique<Pushing>(); }

}  // namespace autoref::runner::truth

// A robot pushes an opponent back.
#include <algorithm>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kPushMargin_m = 20_mm;
constexpr double kOwnMargin_mps = 0.1_mps;

// Two opponents in contact, with the time and their positions when the contact began. The first
// robot belongs to the west team.
struct PushContact {
  RobotId west;
  RobotId east;
  Vec2 west_from_m{0, 0};
  Vec2 east_from_m{0, 0};
  Vec2 west_mps{0, 0};  // velocity in the frame before the contact
  Vec2 east_mps{0, 0};
  bool is_reported = false;
  bool lasts = true;
};

class Pushing final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.is_on) {
      contacts_.clear();
      return;
    }
    for (PushContact& contact : contacts_) contact.lasts = false;
    for_each_robot(frame.now, Side::kWest, [&](RobotId west, const sim::RobotState& a) {
      for_each_robot(frame.now, Side::kEast, [&](RobotId east, const sim::RobotState& b) {
        if (has_contact(frame, west, a, east, b))
          evaluate(frame, contact_of(frame, west, a, east, b), a, b, all);
      });
    });
    const auto over = [](const PushContact& contact) { return !contact.lasts; };
    contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), over), contacts_.end());
  }

 private:
  // Whether the robots touch each other or, under the 2026 rules, both touch the ball.
  static bool has_contact(const TrueFrame& frame, RobotId west, const sim::RobotState& a,
                          RobotId east, const sim::RobotState& b) {
    if (are_in_contact(a, b)) return true;
    return frame.rules.edition == Edition::kRules2026 && frame.ball.has_contact(west) &&
           frame.ball.has_contact(east);
  }

  PushContact& contact_of(const TrueFrame& frame, RobotId west, const sim::RobotState& a,
                          RobotId east, const sim::RobotState& b) {
    for (PushContact& contact : contacts_) {
      if (contact.west != west || contact.east != east) continue;
      contact.lasts = true;
      return contact;
    }
    contacts_.push_back({west, east, a.position_m, b.position_m, a.velocity_mps, b.velocity_mps});
    // A robot that has just been put on the field was not in the previous frame.
    if (const sim::RobotState* before = find_robot(frame.before, west)) {
      contacts_.back().west_mps = before->velocity_mps;
    }
    if (const sim::RobotState* before = find_robot(frame.before, east)) {
      contacts_.back().east_mps = before->velocity_mps;
    }
    return contacts_.back();
  }

  static void evaluate(const TrueFrame& frame, PushContact& contact, const sim::RobotState& a,
                       const sim::RobotState& b, TrueEvents& all) {
    if (contact.is_reported) return;
    const Vec2 east_of = direction_of(b.position_m - a.position_m, Vec2(1.0, 0.0));
    const Vec2 a_moved_m = a.position_m - contact.west_from_m;
    const Vec2 b_moved_m = b.position_m - contact.east_from_m;
    const double path_m = std::min(a_moved_m.dot(east_of), b_moved_m.dot(east_of));
    const double back_m = std::min(-a_moved_m.dot(east_of), -b_moved_m.dot(east_of));
    const bool west_pushes = path_m > back_m;
    const double own_mps =
        west_pushes ? contact.east_mps.dot(east_of) : -contact.west_mps.dot(east_of);
    const double excess_m = std::max(path_m, back_m) - frame.rules.pushing_m;
    const double most_mps = frame.rules.pushing_own_mps;
    if (own_mps > most_mps + kOwnMargin_mps || excess_m <= -kPushMargin_m) return;
    contact.is_reported = excess_m > 0;
    const RobotId pusher = west_pushes ? contact.west : contact.east;
    const TrueEvent push{"bot_pushed_bot", frame.time_s, pusher.side, pusher,
                         Vec2((a.position_m + b.position_m) / 2.0)};
    const bool is_own_motion = own_mps > most_mps;
    add_measured(all, push, is_own_motion ? -kPushMargin_m / 2 : excess_m, kPushMargin_m);
  }

  std::vector<PushContact> contacts_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_pushed_bot() { return std::make_unique<Pushing>(); }

}  // namespace autoref::judge::ground_truth

#include "judge/truth/keepers_ball.hpp"

#include <algorithm>

namespace autoref::judge::ground_truth {

bool is_keepers_ball(const Scene& scene, Side side) {
  if (distance_to_defence_area(scene.field, side, scene.now.ball.position_m) > 0) return false;
  if (scene.rules.edition == Edition::kRules2026) return true;
  const Contacts& contacts = scene.ball.contacts();
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    return contact.robot.side == side && scene.is_keeper(contact.robot);
  });
}

}  // namespace autoref::judge::ground_truth

#include "strategies/plays/formation_spots.hpp"

#include <algorithm>
#include <array>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

class Roster {
 public:
  Roster(PlayContext& book, const RoleAssignment& assignment, const FormationSpots& spots)
      : predicted_(book.predicted), assignment_(assignment), spots_(spots), keys_(book.spots) {}

  // Keeps each spot's current owner if `may_keep` allows it, and leaves all other spots without an
  // owner.
  template <typename MayKeep>
  void forget(MayKeep may_keep) {
    std::array<int, kMaxRobots> kept{};
    for (int i = 0; i < predicted_.robots(); ++i) {
      if (may_keep(i) && spot_of(i) != nullptr) kept[number_of(i)] = key_of(i);
    }
    keys_ = kept;
  }

  // The robot at the ball is assigned the nearest vacant spot.
  void count_in_at_ball() {
    for (int i = 0; i < predicted_.robots(); ++i) {
      if (assignment_.task(i).role != Role::kBall || key_of(i) != 0) continue;
      const FormationSpot* nearest = nullptr;
      for (const FormationSpot& spot : spots_) {
        if (owner_of(spot) >= 0) continue;
        if (nearest == nullptr || path_m(i, spot) < path_m(i, *nearest)) nearest = &spot;
      }
      if (nearest != nullptr) keys_[number_of(i)] = nearest->key;
    }
  }

  // Greedy assignment: the most important spot chooses first, and takes the nearest robot.
  void fill_vacant() {
    for (const FormationSpot& spot : spots_) {
      if (owner_of(spot) >= 0) continue;
      int best = -1;
      for (int i = 0; i < predicted_.robots(); ++i) {
        if (!assignment_.is_free(i) || key_of(i) != 0) continue;
        if (best < 0 || path_m(i, spot) < path_m(best, spot)) best = i;
      }
      if (best >= 0) keys_[number_of(best)] = spot.key;
    }
  }

  // Local search by pairwise exchange: swaps two robots if that clearly shortens the total length
  // of their paths.
  void change_where_better() {
    for (int i = 0; i < predicted_.robots(); ++i) {
      for (int k = i + 1; k < predicted_.robots(); ++k) {
        const FormationSpot* mine = spot_of(i);
        const FormationSpot* other = spot_of(k);
        if (!mine || !other || !assignment_.is_free(i) || !assignment_.is_free(k)) continue;
        const double now_m = path_m(i, *mine) + path_m(k, *other);
        const double changed_m = path_m(i, *other) + path_m(k, *mine);
        if (changed_m < now_m - predicted_.style().worth_a_change_m)
          std::swap(keys_[number_of(i)], keys_[number_of(k)]);
      }
    }
  }

  void send(RoleAssignment& assignment, int count) const {
    for (int p = 0; p < std::min(count, static_cast<int>(spots_.size())); ++p) {
      const FormationSpot& spot = spots_[static_cast<std::size_t>(p)];
      const int owner = owner_of(spot);
      if (owner >= 0 && assignment.is_free(owner))
        assignment.give(owner, Role::kStands, spot.waypoint);
    }
  }

 private:
  int owner_of(const FormationSpot& spot) const {
    for (int i = 0; i < predicted_.robots(); ++i) {
      if (key_of(i) == spot.key) return i;
    }
    return -1;
  }
  std::size_t number_of(int index) const {
    return static_cast<std::size_t>(predicted_.robot(index).number);
  }
  int key_of(int index) const { return keys_[number_of(index)]; }
  const FormationSpot* spot_of(int index) const {
    const auto is_its = [&](const FormationSpot& spot) { return spot.key == key_of(index); };
    const auto found = std::find_if(spots_.begin(), spots_.end(), is_its);
    return found == spots_.end() ? nullptr : &*found;
  }
  double path_m(int index, const FormationSpot& spot) const {
    return (predicted_.robot(index).position_m - spot.waypoint.position_m).norm();
  }

  const PredictedState& predicted_;
  const RoleAssignment& assignment_;
  const FormationSpots& spots_;
  std::array<int, kMaxRobots>& keys_;
};

}  // namespace

void fill_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots) {
  Roster roster(book, assignment, spots);
  roster.forget([&](int index) { return assignment.is_free(index); });
  roster.fill_vacant();
  roster.change_where_better();
  roster.send(assignment, kMaxRobots);
}

void fill_own_spots(PlayContext& book, RoleAssignment& assignment, const FormationSpots& spots,
                    int count) {
  Roster roster(book, assignment, spots);
  roster.forget([&](int index) { return assignment.task(index).role != Role::kKeeper; });
  roster.count_in_at_ball();
  roster.fill_vacant();
  roster.change_where_better();
  roster.send(assignment, count);
}

void send_ahead(PlayContext& book, RoleAssignment& assignment, int count) {
  const PredictedState& predicted = book.predicted;
  boost::container::static_vector<int, kMaxRobots> receivers;
  for (int i = 0; i < predicted.robots(); ++i) {
    if (assignment.is_free(i)) receivers.push_back(i);
  }
  std::sort(receivers.begin(), receivers.end(), [&](int a, int b) {
    return predicted.robot(a).position_m.x() > predicted.robot(b).position_m.x();
  });
  receivers.resize(std::min(receivers.size(), static_cast<std::size_t>(std::max(count, 0))));
  book.field.send(receivers);
  for (const int i : receivers) {
    const Vec2& position_m = book.field.position_of(predicted.robot(i).number);
    assignment.give(i, Role::kReceiver, facing_ball(predicted, position_m));
  }
}

Waypoint off_their_area(const PredictedState& predicted, const Vec2& position_m, double more_m) {
  Limits limits;
  limits.keep_from_area_m = predicted.rules().attacker_to_area_m + kRobotRadius_m +
                            room_for_error_m(predicted.rules()) + more_m;
  return facing_ball(predicted,
                     permitted(predicted.field(), position_m, predicted.position_m(), limits));
}

}  // namespace autoref::strategies

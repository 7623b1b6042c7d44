// Man-marking. Each field player follows its own opponent wherever it goes and whoever has the
// ball; one goes to the ball, and with it a few run free of their men.
#include <algorithm>
#include <cmath>
#include <limits>

#include "strategies/plays/posts.hpp"
#include "strategies/tactics/defend.hpp"
#include "strategies/teams/plans.hpp"

namespace autoref::strategies {
namespace {

// The opponent, by index, that stands nearest to its goal: taken for its keeper.
int their_keeper(const Outlook& outlook) {
  const TrackedRobots& all = outlook.now().opponents;
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kEast);
  int keeper = -1;
  double best_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const double distance_m = (all[static_cast<std::size_t>(i)].position_m - goal_m).norm();
    if (distance_m >= best_m) continue;
    best_m = distance_m;
    keeper = i;
  }
  return keeper;
}

// A post beside each opponent but the keeper, those nearest to the own goal first.
Posts men(const Outlook& outlook) {
  const TrackedRobots& all = outlook.now().opponents;
  const int keeper = their_keeper(outlook);
  Posts posts;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    if (i == keeper) continue;
    const int key = all[static_cast<std::size_t>(i)].number + 1;
    posts.push_back({key, off_their_area(outlook, mark_place(outlook, i).position_m,
                                         outlook.style().way_around_m)});
  }
  const Vec2 goal_m = outlook.field().goal_centre_m(Side::kWest);
  const auto to_goal_m = [&](const Post& post) { return (post.place.position_m - goal_m).norm(); };
  std::sort(posts.begin(), posts.end(),
            [&](const Post& a, const Post& b) { return to_goal_m(a) < to_goal_m(b); });
  return posts;
}

void shadow_men(Playbook& book, Cast& cast, int free_of_men) {
  const Posts posts = men(book.outlook);
  man_own_posts(book, cast, posts, static_cast<int>(posts.size()) - free_of_men);
  send_ahead(book, cast, free_of_men);
  defend(book, cast, cast.free_robots(), 0);
}

void shadow_play(Playbook& book, Cast& cast) {
  give_goal_and_ball(book, cast);
  const int runs = static_cast<int>(std::lround(book.outlook.style().receivers));
  shadow_men(book, cast, book.outlook.is_ours() ? runs : 0);
}

void await_shadow(Playbook& book, Cast& cast) {
  give_goal_and_restart(book, cast);
  shadow_men(book, cast, 0);
}

}  // namespace

Plan shadow_plan() {
  Style style;
  style.receivers = 2;
  return {style, shadow_play, await_shadow};
}

}  // namespace autoref::strategies

#include "strategies/plays/posts.hpp"

#include <algorithm>
#include <array>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

class Roster {
 public:
  Roster(Playbook& book, const Cast& cast, const Posts& posts)
      : outlook_(book.outlook), cast_(cast), posts_(posts), keys_(book.posts) {}

  // Keeps who has one of the posts and may keep it.
  template <typename MayKeep>
  void forget(MayKeep may_keep) {
    std::array<int, kMaxRobots> kept{};
    for (int i = 0; i < outlook_.robots(); ++i) {
      if (may_keep(i) && post_of(i) != nullptr) kept[number_of(i)] = key_of(i);
    }
    keys_ = kept;
  }

  // The robot at the ball is taken to be at the post that is nearest to it.
  void count_in_at_ball() {
    for (int i = 0; i < outlook_.robots(); ++i) {
      if (cast_.task(i).part != Part::kBall || key_of(i) != 0) continue;
      const Post* nearest = nullptr;
      for (const Post& post : posts_) {
        if (owner_of(post) >= 0) continue;
        if (nearest == nullptr || way_m(i, post) < way_m(i, *nearest)) nearest = &post;
      }
      if (nearest != nullptr) keys_[number_of(i)] = nearest->key;
    }
  }

  void fill_vacant() {
    for (const Post& post : posts_) {
      if (owner_of(post) >= 0) continue;
      int best = -1;
      for (int i = 0; i < outlook_.robots(); ++i) {
        if (!cast_.is_free(i) || key_of(i) != 0) continue;
        if (best < 0 || way_m(i, post) < way_m(best, post)) best = i;
      }
      if (best >= 0) keys_[number_of(best)] = post.key;
    }
  }

  void change_where_better() {
    for (int i = 0; i < outlook_.robots(); ++i) {
      for (int k = i + 1; k < outlook_.robots(); ++k) {
        const Post* mine = post_of(i);
        const Post* other = post_of(k);
        if (!mine || !other || !cast_.is_free(i) || !cast_.is_free(k)) continue;
        const double now_m = way_m(i, *mine) + way_m(k, *other);
        const double changed_m = way_m(i, *other) + way_m(k, *mine);
        if (changed_m < now_m - outlook_.style().worth_a_change_m)
          std::swap(keys_[number_of(i)], keys_[number_of(k)]);
      }
    }
  }

  void send(Cast& cast, int count) const {
    for (int p = 0; p < std::min(count, static_cast<int>(posts_.size())); ++p) {
      const Post& post = posts_[static_cast<std::size_t>(p)];
      const int owner = owner_of(post);
      if (owner >= 0 && cast.is_free(owner)) cast.give(owner, Part::kStands, post.place);
    }
  }

 private:
  int owner_of(const Post& post) const {
    for (int i = 0; i < outlook_.robots(); ++i) {
      if (key_of(i) == post.key) return i;
    }
    return -1;
  }
  std::size_t number_of(int index) const {
    return static_cast<std::size_t>(outlook_.robot(index).number);
  }
  int key_of(int index) const { return keys_[number_of(index)]; }
  const Post* post_of(int index) const {
    const auto is_its = [&](const Post& post) { return post.key == key_of(index); };
    const auto found = std::find_if(posts_.begin(), posts_.end(), is_its);
    return found == posts_.end() ? nullptr : &*found;
  }
  double way_m(int index, const Post& post) const {
    return (outlook_.robot(index).position_m - post.place.position_m).norm();
  }

  const Outlook& outlook_;
  const Cast& cast_;
  const Posts& posts_;
  std::array<int, kMaxRobots>& keys_;
};

}  // namespace

void man_posts(Playbook& book, Cast& cast, const Posts& posts) {
  Roster roster(book, cast, posts);
  roster.forget([&](int index) { return cast.is_free(index); });
  roster.fill_vacant();
  roster.change_where_better();
  roster.send(cast, kMaxRobots);
}

void man_own_posts(Playbook& book, Cast& cast, const Posts& posts, int count) {
  Roster roster(book, cast, posts);
  roster.forget([&](int index) { return cast.task(index).part != Part::kKeeper; });
  roster.count_in_at_ball();
  roster.fill_vacant();
  roster.change_where_better();
  roster.send(cast, count);
}

void send_ahead(Playbook& book, Cast& cast, int count) {
  const Outlook& outlook = book.outlook;
  boost::container::static_vector<int, kMaxRobots> receivers;
  for (int i = 0; i < outlook.robots(); ++i) {
    if (cast.is_free(i)) receivers.push_back(i);
  }
  std::sort(receivers.begin(), receivers.end(), [&](int a, int b) {
    return outlook.robot(a).position_m.x() > outlook.robot(b).position_m.x();
  });
  receivers.resize(std::min(receivers.size(), static_cast<std::size_t>(std::max(count, 0))));
  book.field.send(receivers);
  for (const int i : receivers) {
    const Vec2& place_m = book.field.place_of(outlook.robot(i).number);
    cast.give(i, Part::kReceiver, facing_ball(outlook, place_m));
  }
}

Waypoint off_their_area(const Outlook& outlook, const Vec2& place_m, double more_m) {
  Limits limits;
  limits.keep_from_area_m = outlook.rules().attacker_to_area_m + kRobotRadius_m + more_m;
  return facing_ball(outlook, permitted(outlook.field(), place_m, outlook.place_m(), limits));
}

}  // namespace autoref::strategies

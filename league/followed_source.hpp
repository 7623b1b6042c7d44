// Which of several programs that send the same kind of packets is listened to.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace autoref::league {

// The first one, until it has been silent for 1 s; then the next that sends.
class FollowedSource {
 public:
  // Notes a packet of the program `name`, which arrived at `received_s`, on any clock. Returns
  // whether that program is followed.
  bool follows(std::string_view name, double received_s);

  // The program followed, its name cut off after 64 bytes; empty before the first packet.
  const std::string& name() const { return name_; }
  int changes() const { return changes_; }  // how often another program was followed
  int sources() const { return static_cast<int>(sources_.size()); }  // at most 64 are counted

  // The first program that was ignored; empty if there is none.
  const std::string& ignored_name() const { return ignored_name_; }

 private:
  std::set<std::string, std::less<>> sources_;
  std::string name_;
  std::string ignored_name_;
  double heard_s_ = 0;
  int changes_ = 0;
  bool has_ignored_ = false;
};

}  // namespace autoref::league

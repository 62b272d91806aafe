#include "core/search/push_free.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"
#include "core/search/hinge_step.h"
#include "core/search/path_contacts.h"

namespace arcway::internal {

namespace {

// Lengths are in lengths of the body. A path of some tens of parts takes 4 to 80 ms.
constexpr double kLongestPart = 0.5;  // longest part with one curvature; doubled until kMostParts are enough
constexpr std::size_t kMostParts = 48;
constexpr double kRoom = 2e-4;         // beside the body that is asked for, as contacts are found by rounding numbers
constexpr double kMostDepth = 1.5e-4;  // of contacts with the body and that room that are none with the body
constexpr double kNearDepth = 3e-4;    // of contacts of a path that is worth a question to the sweep query
constexpr double kMostLonger = 2.0;    // largest ratio of a path's length to that at first and a body's
constexpr double kEndError = 1e-9;     // [body lengths or rad]
constexpr int kEndIterations = 4;      // of Newton's method, to end at the goal
constexpr int kMostIterations = 160;
constexpr int kPatience = 8;         // iterations after which the sum of squares is compared with that before
constexpr double kSlowest = 0.8;     // the push ends if the sum is larger than this share of it
constexpr int kStepIterations = 30;  // for one step
constexpr double kFirstDamping = 1e-5, kLeastDamping = 1e-8, kMostDamping = 1.0;
constexpr double kSofter = 0.1, kHarder = 10.0;  // after a step that was better, or worse

class Pusher {
 public:
  Pusher(const Path& path, const Pose& goal, const PushSpace& space)
      : start_(path.front().start),
        goal_(goal),
        contacts_(space.outlines, space.body.grown(kRoom * space.body.length())),
        contacts_before_(contacts_),
        radii_(space.vehicle),
        longest_(length_of(path) + contacts_.unit()) {
    for (double longest = kLongestPart * contacts_.unit(); parts_.empty(); longest *= 2.0) {
      for (const PathSegment& s : path) {
        const int count = std::max(1, static_cast<int>(std::ceil(s.length / longest)));
        for (int i = 0; i < count; ++i) parts_.push_back({s.curvature, s.length / count, s.gear, s.is_line()});
      }
      if (parts_.size() > std::max(kMostParts, path.size())) parts_.clear();
    }
  }

  // Levenberg-Marquardt: steps are damped more until they make the path better.
  std::optional<Path> run(const StopClock& clock) {
    if (parts_.size() > 2 * kMostParts) return std::nullopt;
    double damping = kFirstDamping, before_patience = std::numeric_limits<double>::infinity();
    double square_sum = look(parts_);
    for (int iteration = 0; iteration < kMostIterations && !clock.is_over(); ++iteration) {
      if (is_free()) {
        if (!straighten()) return path();
        square_sum = look(parts_);
        before_patience = std::numeric_limits<double>::infinity();
      }
      const bool is_patience_over = iteration % kPatience == 0;
      if (damping > kMostDamping || (is_patience_over && square_sum > kSlowest * before_patience)) {
        if (!bend_lines()) break;
        damping = kFirstDamping;
      }
      if (is_patience_over) before_patience = square_sum;
      std::vector<Part> tried = parts_;
      change(tried, hinge_step(contacts_.residuals(), limits(), damping, kStepIterations));
      end_at_goal(tried);
      std::swap(contacts_, contacts_before_);
      const double now = look(tried);
      const bool is_better = now < square_sum;
      damping = is_better ? std::max(kLeastDamping, kSofter * damping) : kHarder * damping;
      if (is_better) {
        std::swap(parts_, tried);
        square_sum = now;
      } else {
        std::swap(contacts_, contacts_before_);
      }
    }
    if (is_nearly_free()) return path();
    return std::nullopt;
  }

 private:
  struct Part {
    double curvature, length;
    Gear gear;
    bool is_line;  // stays one
  };

  [[nodiscard]] std::vector<PathSegment> motions_of(const std::vector<Part>& parts) const {
    std::vector<PathSegment> motions;
    Pose pose = start_;
    for (const Part& p : parts) {
      motions.push_back({pose, p.length, p.curvature, p.gear});
      pose = motions.back().end();
    }
    return motions;
  }

  // The sum of squares; infinite for a path that has become so long that looking along it would take long.
  double look(const std::vector<Part>& parts) {
    const double length = std::accumulate(parts.begin(), parts.end(), 0.0,
                                          [](double sum, const Part& part) { return sum + part.length; });
    if (length > kMostLonger * longest_) return std::numeric_limits<double>::infinity();
    contacts_.look_along(motions_of(parts), goal_);
    return contacts_.square_sum();
  }
  [[nodiscard]] bool is_free() const { return contacts_.deepest() < kMostDepth && contacts_.off_goal() <= kEndError; }

  // The sweep query is asked all the same: where the path begins or ends there may be less room.
  [[nodiscard]] bool is_nearly_free() const {
    return contacts_.deepest() < kNearDepth && contacts_.off_goal() <= kEndError;
  }

  // Lets lines become arcs; false if they may already.
  bool bend_lines() {
    if (std::exchange(are_lines_bent_, true)) return false;
    bool any = false;
    for (Part& part : parts_) any = std::exchange(part.is_line, false) || any;
    return any;
  }

  [[nodiscard]] StepLimits limits() const {
    const auto n = static_cast<Eigen::Index>(2 * parts_.size());
    StepLimits limits{Eigen::VectorXd(n), Eigen::VectorXd(n)};
    const double to_left = contacts_.unit() / radii_.left, to_right = contacts_.unit() / radii_.right;
    for (Eigen::Index k = 0; k < n; k += 2) {
      const Part& part = parts_[static_cast<std::size_t>(k / 2)];
      const double bend = part.curvature * contacts_.unit();
      limits.low(k) = part.is_line ? 0.0 : std::min(0.0, -to_right - bend);
      limits.high(k) = part.is_line ? 0.0 : std::max(0.0, to_left - bend);
      limits.low(k + 1) = -part.length / contacts_.unit();
      limits.high(k + 1) = std::numeric_limits<double>::infinity();
    }
    return limits;
  }

  void change(std::vector<Part>& parts, const Eigen::VectorXd& step) const {
    const double to_left = 1.0 / radii_.left, to_right = 1.0 / radii_.right;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(2 * i);
      Part& part = parts[i];
      if (!part.is_line) part.curvature = std::clamp(part.curvature + step(k) / contacts_.unit(), -to_right, to_left);
      part.length = std::max(0.0, part.length + step(k + 1) * contacts_.unit());
    }
  }

  // The least change after which a path ends at the goal.
  void end_at_goal(std::vector<Part>& parts) const {
    for (int iteration = 0; iteration < kEndIterations; ++iteration) {
      const std::vector<PathSegment> motions = motions_of(parts);
      const Pose end = motions.back().end();
      const Vec2 off = (goal_.position() - end.position()) / contacts_.unit();
      const Eigen::Vector3d rest(off.x(), off.y(), wrap_signed(goal_.heading - end.heading));
      auto by = contacts_.end_gradients(motions);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(2 * i);
        if (parts[i].is_line || std::abs(parts[i].curvature) * radii_.on(parts[i].curvature) >= 1.0)
          by.col(k).setZero();
        if (parts[i].length <= 0.0) by.col(k + 1).setZero();
      }
      const Eigen::Matrix3d square = by * by.transpose();
      change(parts, by.transpose() * square.ldlt().solve(rest));
    }
  }

  // Arcs that are too wide for their centers become lines; false if there is none.
  bool straighten() {
    bool any = false;
    for (Part& part : parts_) {
      if (part.is_line || std::abs(part.curvature) * radii_.on(part.curvature) * kWidestTurn >= 1.0) continue;
      any = any || part.curvature != 0.0;
      part = {0.0, part.length, part.gear, true};
    }
    return any;
  }

  [[nodiscard]] Path path() const {
    Path path = motions_of(parts_);
    std::erase_if(path, [](const PathSegment& s) { return s.length <= 0.0; });
    return merged(path);
  }

  Pose start_, goal_;
  PathContacts contacts_;         // of the parts
  PathContacts contacts_before_;  // memory: of the parts before a step
  SideRadii radii_;               // the smallest ones
  std::vector<Part> parts_;
  double longest_;  // length at first, and some more [m]
  bool are_lines_bent_ = false;
};

}  // namespace

std::optional<Path> push_free(const Path& path, const Pose& goal, const PushSpace& space, const StopClock& clock) {
  std::optional<Path> free = Pusher(path, goal, space).run(clock);
  if (free && !motion_free(space.sweep, space.body, *free)) free.reset();
  return free;
}

}  // namespace arcway::internal

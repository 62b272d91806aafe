#include "arcway/heading_set.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"

namespace arcway {

using namespace internal;

HeadingSet HeadingSet::complement(std::vector<HeadingInterval> blocked) {
  HeadingSet result;
  complement(blocked, result);
  return result;
}

void HeadingSet::complement(std::vector<HeadingInterval>& blocked, HeadingSet& result) {
  std::vector<HeadingInterval>& free = result.intervals_;
  free.clear();
  if (blocked.empty()) {
    free.push_back({0.0, kFullCircle});
    return;
  }
  // Within [0, 2 pi]: those that pass the seam in two pieces.
  for (std::size_t i = 0, count = blocked.size(); i < count; ++i) {
    const double extent = blocked[i].high - blocked[i].low;
    if (extent >= kFullCircle) return;
    const double low = wrap_positive(blocked[i].low);
    const double high = low + extent;
    blocked[i] = {low, std::min(high, kFullCircle)};
    if (high >= kFullCircle) blocked.push_back({0.0, high - kFullCircle});
  }
  std::sort(blocked.begin(), blocked.end(), [](const auto& a, const auto& b) { return a.low < b.low; });

  const auto add = [&free](double low, double high) {
    low = std::nextafter(low, kFullCircle * 2);
    high = std::nextafter(high, -1.0);
    if (low <= high && low < kFullCircle) free.push_back({low, high});
  };
  double reached = 0.0;
  const bool open_at_seam = blocked.front().low > 0.0;
  if (open_at_seam) free.push_back({0.0, std::nextafter(blocked.front().low, -1.0)});
  for (const HeadingInterval& b : blocked) {
    if (b.low > reached && reached > 0.0) add(reached, b.low);
    reached = std::max({reached, b.high, std::numeric_limits<double>::min()});
  }
  if (reached < kFullCircle) {
    const double low = std::nextafter(reached, kFullCircle * 2);
    if (open_at_seam && low < kFullCircle) {  // one interval across the seam
      const double high = free.front().high + kFullCircle;
      free.erase(free.begin());
      free.push_back({low, std::nextafter(high, -1.0)});
    } else {
      add(reached, kFullCircle);
    }
  }
}

HeadingSet HeadingSet::of_intervals(std::vector<HeadingInterval> intervals) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto [low, high] = intervals[i];
    const double limit = i + 1 < intervals.size() ? intervals[i + 1].low : intervals[0].low + kFullCircle;
    const bool is_full_circle = intervals.size() == 1 && low == 0.0 && high == kFullCircle;
    if (!(low >= 0.0 && low < kFullCircle && high >= low && high < limit) && !is_full_circle)
      throw std::invalid_argument("heading interval " + std::to_string(i) + " is from " + shortest_text(low) + " to " +
                                  shortest_text(high) + ", must begin in [0, 2 pi) and end below " +
                                  shortest_text(limit) + ", where the next one begins");
  }
  return HeadingSet(std::move(intervals));
}

bool HeadingSet::is_full() const {
  return intervals_.size() == 1 && intervals_[0].high - intervals_[0].low >= kFullCircle;
}

int HeadingSet::find(double heading) const {
  if (intervals_.empty()) return -1;
  const double h = wrap_positive(heading);
  const auto after = std::upper_bound(intervals_.begin(), intervals_.end(), h,
                                      [](double value, const HeadingInterval& i) { return value < i.low; });
  if (after != intervals_.begin() && h <= (after - 1)->high) return static_cast<int>(after - intervals_.begin()) - 1;
  if (h + kFullCircle <= intervals_.back().high) return static_cast<int>(intervals_.size()) - 1;
  return -1;
}

double reach_within(const HeadingInterval& interval, double heading, Side side) {
  const double wrapped = wrap_positive(heading);
  const double h = wrapped < interval.low ? wrapped + kTwoPi : wrapped;
  if (h > interval.high) return -1.0;
  if (interval.high - interval.low >= kTwoPi) return kTwoPi;
  return side == Side::kLeft ? interval.high - h : h - interval.low;
}

double HeadingSet::reach(double heading, Side side) const {
  const int index = find(heading);
  return index < 0 ? -1.0 : reach_within(intervals_[static_cast<std::size_t>(index)], heading, side);
}

HeadingSet HeadingSet::around(double heading, double most) const {
  const int index = find(heading);
  if (index < 0) return {};
  const HeadingInterval& interval = intervals_[static_cast<std::size_t>(index)];
  const double right = std::min(most, reach_within(interval, heading, Side::kRight));
  const double left = std::min(most, reach_within(interval, heading, Side::kLeft));
  const double low = wrap_positive(heading - right);
  return HeadingSet({{low, low + right + left}});
}

}  // namespace arcway

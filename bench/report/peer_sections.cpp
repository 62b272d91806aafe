#include "bench/report/peer_sections.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "bench/quantiles.h"
#include "bench/report/least_queries.h"
#include "bench/report/map_sections.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/report/vehicle_sections.h"
#include "bench/report/words.h"
#include "bench/robots.h"

namespace arcway::internal::report {
namespace {

std::string quantiles_text(std::vector<double> values, std::initializer_list<double> shares) {
  if (values.empty()) return "–";
  std::string text;
  for (const double share : shares)
    text += (text.empty() ? "" : " / ") + number_text("%.3f", bench::quantile(values, share));
  return text;
}

/// Processor times would hide what several threads gain.
bool is_by_wall(const Duel& d) { return d.threads > 1; }

/// Peer over us, run by run: above 1 we are faster.
std::vector<double> ratios_of(const Duel& d) {
  const std::vector<double>& ours = is_by_wall(d) ? d.our_wall_seconds : d.our_seconds;
  const std::vector<double>& peers = is_by_wall(d) ? d.peer_wall_seconds : d.peer_seconds;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < ours.size(); ++i) ratios.push_back(peers[i] / ours[i]);
  return ratios;
}

/// "70 ms", "wall 40 ms, processor 70 ms", marked if it is noisy.
std::string duel_time_text(const Duel& d, const std::vector<double>& wall, const std::vector<double>& processor) {
  const std::string time = time_text(bench::median(processor));
  return marked(is_by_wall(d) ? "wall " + time_text(bench::median(wall)) + ", processor " + time : time,
                !noise_of(wall, processor, is_by_wall(d)).empty());
}

/// Why a duel is noisy: by arcway's times, by the peer's, or both.
std::string duel_noise(const Duel& d) {
  const std::string ours = noise_of(d.our_wall_seconds, d.our_seconds, is_by_wall(d));
  const std::string peers = noise_of(d.peer_wall_seconds, d.peer_seconds, is_by_wall(d));
  return (ours.empty() ? "" : "arcway: " + ours) + (ours.empty() || peers.empty() ? "" : "; ") +
         (peers.empty() ? "" : d.peer + ": " + peers);
}

std::string title_of(const Duel& d) { return d.task + ": " + d.peer; }

/// All queries of one planner, in all worlds or one.
struct Record {
  std::string planner;
  std::size_t queries = 0, solved = 0, valid = 0;
  std::size_t ours_alone = 0, theirs_alone = 0, faster_path = 0, slower_path = 0;
  std::size_t faster_at_all = 0;  // without the tolerance
  std::vector<double> seconds, over_bound, over_best, over_ours;
  std::map<std::string, int> reasons;
};

bool is_slower(double time, double other) { return time > (1.0 + kTravelTimeTolerance) * other; }

/// "0.1 %"
std::string tolerance_text() { return number_text("%g", 100.0 * kTravelTimeTolerance) + " %"; }

/// The duel that a stranger hears of.
constexpr const char* kGraphTask = "reduced graph";

bool is_peer(const std::string& planner) { return !planner.starts_with("arcway"); }
/// Planners that went on after their first path.
bool goes_on(const std::string& planner) { return !planner.ends_with(" first"); }

/// Seconds in "ompl_rrtconnect 10 s"; 0 without any.
double limit_of(const std::string& planner) {
  const std::size_t space = planner.rfind(' ', planner.size() - 3);
  return planner.ends_with(" s") && space != std::string::npos ? std::strtod(planner.c_str() + space, nullptr) : 0.0;
}

/// A planner without when its answer was taken: "ompl_rrtconnect" of "ompl_rrtconnect first" and "ompl_rrtconnect 10
/// s".
std::string base_name(const std::string& planner) {
  if (!goes_on(planner)) return planner.substr(0, planner.rfind(' '));
  return limit_of(planner) > 0.0 ? planner.substr(0, planner.rfind(' ', planner.size() - 3)) : planner;
}

void count(Record& record, const PlannerQuery& query, const PlannerAnswer& answer, const PlannerAnswer& ours,
           double best) {
  ++record.queries;
  const bool counts = answer.solved() && answer.valid;
  record.ours_alone += ours.solved() && !counts;
  record.theirs_alone += counts && !ours.solved();
  if (!answer.solved()) {
    ++record.reasons[answer.status];
    return;
  }
  ++record.solved;
  record.valid += answer.valid;
  record.seconds.push_back(answer.seconds);
  record.over_bound.push_back(answer.travel_time / query.lower_bound);
  record.over_best.push_back(answer.travel_time / best);
  if (!ours.solved() || !answer.valid) return;
  record.over_ours.push_back(answer.travel_time / ours.travel_time);
  record.faster_path += is_slower(ours.travel_time, answer.travel_time);
  record.slower_path += is_slower(answer.travel_time, ours.travel_time);
  record.faster_at_all += answer.travel_time < ours.travel_time;
}

/// @param world  empty: all.
std::vector<Record> records_of(const PeerResults& peers, const std::string& setting, const std::string& world = {}) {
  std::vector<Record> records;
  for (const PlannerQuery& q : peers.queries) {
    if (q.setting != setting || (!world.empty() && q.world != world)) continue;
    double best = std::numeric_limits<double>::infinity();
    for (const PlannerAnswer& a : q.answers)
      if (a.solved() && a.valid) best = std::min(best, a.travel_time);
    for (const PlannerAnswer& a : q.answers) {
      auto record = std::ranges::find(records, a.planner, &Record::planner);
      if (record == records.end()) {
        record = records.insert(records.end(), Record());
        record->planner = a.planner;
      }
      count(*record, q, a, q.answers.front(), best);
    }
  }
  return records;
}

std::string reasons_text(const Record& record) {
  std::string text;
  for (const auto& [reason, times] : record.reasons)
    text += (text.empty() ? "" : ", ") + std::to_string(times) + " " + reason;
  return text;
}

std::vector<std::string> record_row(const Record& r) {
  return {r.planner,
          std::to_string(r.solved) + " of " + std::to_string(r.queries),
          std::to_string(r.valid),
          r.seconds.empty() ? "–" : time_text(bench::median(r.seconds)),
          quantiles_text(r.over_bound, {0.25, 0.5, 0.75}),
          quantiles_text(r.over_best, {0.5, 0.9, 1.0}),
          quantiles_text(r.over_ours, {0.0, 0.5, 1.0}),
          std::to_string(r.faster_path) + " / " + std::to_string(r.slower_path),
          std::to_string(r.theirs_alone) + " / " + std::to_string(r.ours_alone)};
}

const std::vector<std::string> kRecordHeader = {"planner",
                                                "solved",
                                                "valid",
                                                "time to the answer",
                                                "travel time / bound: 25 %, median, 75 %",
                                                "/ best known: median, 90 %, worst",
                                                "/ arcway's: least, median, most",
                                                "faster / slower than arcway's by more than " + tolerance_text(),
                                                "solves alone / arcway alone"};

/// Whether medians over the solved queries say anything.
bool has_enough(const Record& r) { return static_cast<double>(r.solved) >= kLeastQueries; }

/// "99.6 %"; never rounded up to all.
std::string share_text(std::size_t part, std::size_t all) {
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(all);
  return part == all ? "100 %" : number_text("%.1f", std::min(percent, 99.9)) + " %";
}

/// A planner's records after its first path, 1 s, 10 s make one curve.
std::vector<Curve> trade_off(const std::vector<Record>& records) {
  std::vector<Curve> curves;
  for (const Record& r : records) {
    if (!has_enough(r)) continue;
    const std::string name = planner_words(base_name(r.planner));
    auto curve = std::ranges::find(curves, name, &Curve::name);
    if (curve == curves.end()) curve = curves.insert(curves.end(), Curve{name, {}, {}});
    curve->points.push_back({bench::median(r.seconds), bench::quantile(r.over_bound, 0.5),
                             bench::quantile(r.over_bound, 0.25), bench::quantile(r.over_bound, 0.75)});
  }
  for (Curve& curve : curves) std::ranges::sort(curve.points, {}, &Curve::Point::x);
  return curves;
}

/// Settings that one claim is made for.
struct Group {
  const char* name;
  bool (*has)(const std::string& setting);
};
bool is_of_real_vehicle(const std::string& setting) { return vehicle_rank(setting) < bench::real_vehicles().size(); }
bool is_of_limited_robot(const std::string& setting) { return setting.starts_with("lateral"); }
constexpr Group kGroups[] = {
    {"real vehicles", is_of_real_vehicle},
    {"the paper's robot with limits on its acceleration", is_of_limited_robot},
    {"the paper's robot",
     [](const std::string& s) { return !is_of_real_vehicle(s) && !is_of_limited_robot(s) && !is_own_setting(s); }},
    {"these maps", is_own_setting}};

bool has_own_maps(const PeerResults& peers) {
  return std::ranges::any_of(peers.queries, is_own_setting, &PlannerQuery::setting);
}

/// By group and vehicle, each in the order of the file.
std::vector<std::string> settings_of(const PeerResults& peers) {
  std::vector<std::string> settings;
  for (const PlannerQuery& q : peers.queries)
    if (std::ranges::find(settings, q.setting) == settings.end()) settings.push_back(q.setting);
  std::ranges::stable_sort(settings, {}, [](const std::string& setting) {
    const auto group = std::ranges::find_if(kGroups, [&](const Group& g) { return g.has(setting); });
    return std::pair(group - std::begin(kGroups), vehicle_rank(setting));
  });
  return settings;
}

std::vector<std::string> worlds_of(const PeerResults& peers, const std::string& setting) {
  std::vector<std::string> worlds;
  for (const PlannerQuery& q : peers.queries)
    if (q.setting == setting && std::ranges::find(worlds, q.world) == worlds.end()) worlds.push_back(q.world);
  return worlds;
}

/// The duels of each task and peer on the largest map that both did.
std::vector<const Duel*> largest_duels(const PeerResults& peers) {
  std::vector<const Duel*> largest;
  for (const Duel& d : peers.duels) {
    if (!d.error.empty()) continue;
    const auto known = std::ranges::find(largest, title_of(d), [](const Duel* other) { return title_of(*other); });
    if (known == largest.end()) {
      largest.push_back(&d);
    } else if (d.vertices >= (*known)->vertices) {
      *known = &d;
    }
  }
  return largest;
}

void add_duel_findings(const PeerResults& peers, std::vector<std::string>& sentences) {
  std::map<std::string, std::string> by_peer;
  std::string losses;
  for (const Duel* d : largest_duels(peers)) {
    const double ratio = bench::median(ratios_of(*d));
    std::string& list = by_peer[d->peer];
    list += (list.empty() ? " " : ", ") + ratio_text(ratio) + " (" + d->task + ")";
    if (ratio < 1.0) losses += (losses.empty() ? "" : ", ") + d->task + " (" + d->peer + ")";
  }
  std::string text = "Visibility: a peer's time over arcway's, for equal answers on the largest map that both did:";
  for (const auto& [peer, list] : by_peer) text += " " + peer + list + ";";
  sentences.push_back(text + (losses.empty() ? " no peer wins." : " a peer wins " + losses + "."));
}

void add_planner_findings(const PeerResults& peers, const std::string& setting, std::vector<std::string>& sentences) {
  const std::vector<Record> records = records_of(peers, setting);
  if (records.empty() || records.front().solved == 0) return;
  const Record& ours = records.front();
  std::string text = setting_words(setting) + ": arcway solves " + std::to_string(ours.solved) + " of " +
                     std::to_string(ours.queries) + " queries in " + time_text(bench::median(ours.seconds)) + " each";
  for (const Record& r : records) {
    if (!is_peer(r.planner) || !goes_on(r.planner) || r.queries < ours.queries) continue;
    text += "; " + planner_words(r.planner) + " solves " + std::to_string(r.solved) + ", with faster paths on " +
            std::to_string(r.faster_path) + " and slower ones on " + std::to_string(r.slower_path) +
            (r.theirs_alone > 0 ? ", " + std::to_string(r.theirs_alone) + " of them alone" : "");
  }
  sentences.push_back(text + ". Times within " + tolerance_text() + " count as equal.");
}

/// What is found of the paths of one group of settings.
std::string claim_text(const PeerResults& peers, const Group& group) {
  std::size_t both = 0, slower = 0, alone = 0;
  double worst = 1.0;
  for (const std::string& setting : settings_of(peers)) {
    if (!group.has(setting)) continue;
    for (const Record& r : records_of(peers, setting)) {
      if (!is_peer(r.planner) || !goes_on(r.planner)) continue;
      both += r.over_ours.size();
      slower += r.faster_path;
      alone += r.theirs_alone;
      for (const double ratio : r.over_ours) worst = std::max(worst, 1.0 / ratio);
    }
  }
  if (both == 0) return std::string(group.name) + ": not compared in these results";
  return std::string(group.name) + ": not slower in " + share_text(both - slower, both) + " of " +
         count_text(static_cast<double>(both)) + " comparisons, at worst by " +
         number_text("%.2f", 100.0 * (worst - 1.0)) + " %, and " + std::to_string(alone) +
         " answers of peers where arcway has none";
}

std::string claims_finding(const PeerResults& peers) {
  std::string text = "Not slower than a peer's improved path, where a travel time at most " + tolerance_text() +
                     " longer counts as not slower:";
  const bool is_own = has_own_maps(peers);
  std::string claims;
  for (const Group& group : kGroups)
    if ((group.has == is_own_setting) == is_own) claims += (claims.empty() ? " " : "; ") + claim_text(peers, group);
  return text + claims + ".";
}

}  // namespace

std::string planner_comparison(const PeerResults& peers) {
  std::vector<std::string> names;
  std::size_t both = 0, slower = 0, ours_alone = 0, theirs_alone = 0;
  double worst = 1.0, limit = 0.0;
  for (const std::string& setting : settings_of(peers))
    for (const Record& r : records_of(peers, setting)) {
      if (!is_peer(r.planner) || !goes_on(r.planner)) continue;
      const std::string name = planner_words(base_name(r.planner));
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
      both += r.over_ours.size();
      slower += r.faster_path;
      ours_alone += r.ours_alone;
      theirs_alone += r.theirs_alone;
      limit = std::max(limit, limit_of(r.planner));
      for (const double ratio : r.over_ours) worst = std::max(worst, 1.0 / ratio);
    }
  if (both == 0) return {};
  const auto count = [](std::size_t n) { return count_text(static_cast<double>(n)); };
  return listed(names) + ", which had up to " + number_text("%g", limit) +
         " s for each task, found a faster drive in " + count(slower) + " of " + count(both) + " comparisons" +
         (slower == 0 ? "" : ", by at most " + number_text("%.1f", 100.0 * (worst - 1.0)) + " %") + "; " +
         count(ours_alone) + " times arcway alone found one, " + count(theirs_alone) + " times another alone.";
}

std::string duel_comparison(const PeerResults& peers) {
  std::vector<std::string> parts;
  for (const Duel* d : largest_duels(peers))
    if (d->task == kGraphTask)
      parts.push_back("with " + d->peer + " " + ratio_text(bench::median(ratios_of(*d))) + " times");
  if (parts.empty()) return {};
  return "Finding which corners of the obstacles see each other takes " + listed(parts) +
         " as long as with arcway, on the largest map that both did.";
}

std::vector<std::string> peer_findings(const PeerResults& peers) {
  std::vector<std::string> sentences;
  if (!peers.duels.empty()) add_duel_findings(peers, sentences);
  if (!peers.queries.empty()) sentences.push_back(claims_finding(peers));
  return sentences;
}

Section duels_section(const PeerResults& peers) {
  Section section{
      .title = "Visibility: arcway and its peers in turn",
      .paragraphs = {"One thread each, processor time, the map prepared within the time; answers compared before the "
                     "clock starts, but for the triangulation, which is only a part of the work. Ratio: the peer's "
                     "time over arcway's, run by run; below 1 the peer wins. Where arcway has two threads both go by "
                     "the wall clock; that means something only on a machine with nothing else to do, which shows in "
                     "wall and processor time of the peer being the same. " +
                     mark_meaning()},
      .figures = {},
      .table = {
          {"task", "peer", "vertices", "arcway", "peer's time", "ratio: median", "least – most", "faster"}, {}, 2}};
  for (const Duel& d : peers.duels) {
    if (!d.error.empty()) {
      section.table.rows.push_back({d.task, d.peer, count_text(d.vertices), d.error, "", "", "", ""});
      continue;
    }
    const std::vector<double> ratios = ratios_of(d);
    const auto [low, high] = std::ranges::minmax(ratios);
    section.table.rows.push_back({d.task, d.peer, count_text(d.vertices),
                                  duel_time_text(d, d.our_wall_seconds, d.our_seconds),
                                  duel_time_text(d, d.peer_wall_seconds, d.peer_seconds),
                                  ratio_text(bench::median(ratios)), ratio_text(low) + " – " + ratio_text(high),
                                  low > 1.0    ? "arcway"
                                  : high < 1.0 ? d.peer
                                               : "neither"});
  }
  return section;
}

std::vector<std::string> duel_figures(const PeerResults& peers) {
  std::vector<Curve> duels;
  for (const Duel& d : peers.duels) {
    if (!d.error.empty()) continue;
    const std::vector<double> ratios = ratios_of(d);
    const auto [low, high] = std::ranges::minmax(ratios);
    auto curve = std::ranges::find(duels, title_of(d), &Curve::name);
    if (curve == duels.end()) curve = duels.insert(duels.end(), Curve{title_of(d), {}, {}});
    curve->points.push_back({d.vertices, bench::median(ratios), low, high, duel_noise(d)});
  }
  std::vector<std::string> figures;
  if (!duels.empty())
    figures.push_back(figure_html({.title = "The peers' time over arcway's, over the vertices of the map",
                                   .x_label = "vertices of the map",
                                   .y_label = "peer's time / arcway's",
                                   .y_text = ratio_text,
                                   .level = 1.0},
                                  duels, "Visibility: above the line at 1 arcway is faster, below it the peer."));
  return figures;
}

std::vector<std::string> planner_figures(const PeerResults& peers) {
  std::vector<std::string> figures, settings = settings_of(peers);
  std::ranges::stable_sort(settings, {}, [&](const std::string& setting) {
    return std::pair(!is_of_real_vehicle(setting), -std::ranges::count(peers.queries, setting, &PlannerQuery::setting));
  });
  for (const std::string& setting : settings) {
    const std::vector<Curve> planners = trade_off(records_of(peers, setting));
    if (planners.empty()) continue;
    figures.push_back(figure_html(
        {.title = "Travel time over the lower bound, over the time to the answer: " + setting_words(setting),
         .x_label = "time to the answer, processor time, median",
         .y_label = "travel time / lower bound",
         .x_text = time_text,
         .y_text = ratio_text},
        planners,
        "Planners, " + setting_words(setting) +
            ": left is sooner, down is a faster path. Bars: the middle half of the queries. "
            "The bound is that of a point, so that a car cannot reach 1."));
  }
  return figures;
}

Section claims_section(const PeerResults& peers) {
  Section section{
      .title = "Not slower than a peer",
      .paragraphs =
          {"On how many queries arcway's path is not slower than that of a peer which improves its path until "
           "its time is over. With the tolerance, a travel time at most " +
           tolerance_text() +
           " longer counts as not slower; at all: without it. Real vehicles first, if they were compared."},
      .figures = {},
      .table = {{"setting", "peer", "both solve", "not slower, " + tolerance_text(), "not slower at all",
                 "arcway slower by, most", "peer slower by: median, most", "peer alone solves", "arcway alone solves"},
                {},
                2}};
  std::size_t hidden = 0;
  const auto more_text = [](double ratio) { return number_text("%.2f", 100.0 * std::max(0.0, ratio - 1.0)) + " %"; };
  for (const std::string& setting : settings_of(peers))
    for (const Record& r : records_of(peers, setting)) {
      if (!is_peer(r.planner) || !goes_on(r.planner) || r.over_ours.empty()) continue;
      const std::size_t both = r.over_ours.size();
      if (static_cast<double>(both) < kLeastQueries) {
        ++hidden;
        continue;
      }
      const auto [low, high] = std::ranges::minmax(r.over_ours);
      section.table.rows.push_back({setting, r.planner, std::to_string(both), share_text(both - r.faster_path, both),
                                    share_text(both - r.faster_at_all, both), more_text(1.0 / low),
                                    more_text(bench::median(r.over_ours)) + ", " + more_text(high),
                                    std::to_string(r.theirs_alone), std::to_string(r.ours_alone)});
    }
  if (hidden > 0) section.paragraphs.push_back(hidden_rows_text(hidden));
  if (!has_own_maps(peers) &&
      std::ranges::none_of(section.table.rows, [](const auto& row) { return is_of_real_vehicle(row.front()); }))
    section.paragraphs.emplace_back("Real vehicles were not compared in these results.");
  return section;
}

Section losses_section(const PeerResults& peers) {
  Section section{
      .title = "Where a peer does better",
      .paragraphs = {"Every query that a peer alone solves, or with a path that is faster by more than " +
                     tolerance_text() + "."},
      .figures = {},
      .table = {{"setting", "world", "query", "peer", "its travel time", "arcway's", "arcway slower by"}, {}, 4}};
  for (const PlannerQuery& q : peers.queries) {
    const PlannerAnswer& ours = q.answers.front();
    for (const PlannerAnswer& a : q.answers) {
      if (!is_peer(a.planner) || !a.solved() || !a.valid) continue;
      if (ours.solved() && !is_slower(ours.travel_time, a.travel_time)) continue;
      section.table.rows.push_back(
          {q.setting, q.world, std::to_string(q.query), a.planner, number_text("%.3f s", a.travel_time),
           ours.solved() ? number_text("%.3f s", ours.travel_time) : ours.status,
           ours.solved() ? number_text("%.2f %%", 100.0 * (ours.travel_time / a.travel_time - 1.0)) : "–"});
    }
  }
  return section;
}

Section planners_section(const PeerResults& peers) {
  Section section{
      .title = "Planners: time against quality",
      .paragraphs =
          {"Forward-only car, the same queries, maps and exact collision checks for all, one thread, "
           "processor time. `arcway` answers on a map that was prepared before; `arcway, map and all`, where the "
           "study has it, begins with the bare map, as the peers do, for one query. What is only "
           "in the peers' favor: after the first path they go on to improve it until the time is up. `arcway first` "
           "is the first path, before refinement; `arcway_tightest` turns as tightly as it can only."},
      .figures = {},
      .table = {kRecordHeader, {}, 2}};
  if (!has_own_maps(peers))
    section.paragraphs.emplace_back(
        "Settings: real vehicles on maps of their size with 100 obstacles, as far as they were compared; the paper's "
        "robot with limits on its acceleration in clutters of 100, fill 0.15 and 0.3; the paper's robot in clutters of "
        "100 and of 1,000 obstacles.");
  section.table.header.insert(section.table.header.begin(), "setting");
  std::size_t hidden = 0;
  for (const std::string& setting : settings_of(peers)) add_planner_findings(peers, setting, section.paragraphs);
  for (const std::string& setting : settings_of(peers))
    for (const Record& r : records_of(peers, setting)) {
      if (!has_enough(r)) {
        ++hidden;
        continue;
      }
      section.table.rows.push_back(record_row(r));
      section.table.rows.back().insert(section.table.rows.back().begin(), setting);
    }
  if (hidden > 0) section.paragraphs.push_back(hidden_rows_text(hidden));
  return section;
}

Section planners_by_world_section(const PeerResults& peers) {
  Section section{
      .title = "Planners by world", .paragraphs = {}, .figures = {}, .table = {kRecordHeader, {}, 3}, .folded = true};
  std::vector<std::string>& header = section.table.header;
  header.insert(header.begin(), {"setting", "world"});
  header.emplace_back("why not solved");
  std::size_t hidden = 0;
  for (const std::string& setting : settings_of(peers))
    for (const std::string& world : worlds_of(peers, setting))
      for (const Record& r : records_of(peers, setting, world)) {
        if (!has_enough(r)) {
          ++hidden;
          continue;
        }
        std::vector<std::string> row = record_row(r);
        row.insert(row.begin(), {setting, world});
        row.push_back(reasons_text(r));
        section.table.rows.push_back(std::move(row));
      }
  if (hidden > 0) section.paragraphs.push_back(hidden_rows_text(hidden));
  return section;
}

}  // namespace arcway::internal::report

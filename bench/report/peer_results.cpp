#include "bench/report/peer_results.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>

#include "arcway/datasets/file_io.h"
#include "bench/report/json_message.h"

namespace arcway::internal::report {
namespace {

using nlohmann::ordered_json;

constexpr const char* kFormat = "arcway-peers";
constexpr const char* kFirstSetting = "n100";  // setting of files that name none

/// Times and ratios are read by people: six digits say enough.
double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

ordered_json rounded(const std::vector<double>& values) {
  ordered_json array = ordered_json::array();
  for (const double value : values) array.push_back(rounded(value));
  return array;
}

ordered_json to_json(const Duel& d) {
  ordered_json json{{"task", d.task}, {"world", d.world}, {"vertices", d.vertices}, {"ours", d.ours}, {"peer", d.peer}};
  if (!d.error.empty()) {
    json["error"] = d.error;
    return json;
  }
  json["our_seconds"] = rounded(d.our_seconds);
  json["peer_seconds"] = rounded(d.peer_seconds);
  if (!d.our_wall_seconds.empty()) {
    json["our_wall_seconds"] = rounded(d.our_wall_seconds);
    json["peer_wall_seconds"] = rounded(d.peer_wall_seconds);
  }
  if (d.threads > 1) json["threads"] = d.threads;
  return json;
}

ordered_json to_json(const PlannerQuery& q) {
  ordered_json answers = ordered_json::array();
  for (const PlannerAnswer& a : q.answers) {
    ordered_json answer{{"planner", a.planner}, {"status", a.status}, {"seconds", rounded(a.seconds)}};
    if (a.solved()) answer.update({{"travel_time", rounded(a.travel_time)}, {"valid", a.valid}});
    answers.push_back(std::move(answer));
  }
  return {{"setting", q.setting},
          {"world", q.world},
          {"query", q.query},
          {"lower_bound", rounded(q.lower_bound)},
          {"answers", answers}};
}

Duel duel_of(const ordered_json& json) {
  Duel d;
  d.task = json.at("task");
  d.world = json.at("world");
  d.vertices = json.at("vertices");
  d.ours = json.at("ours");
  d.peer = json.at("peer");
  d.error = json.value("error", "");
  if (!d.error.empty()) return d;
  d.our_seconds = json.at("our_seconds").get<std::vector<double>>();
  d.peer_seconds = json.at("peer_seconds").get<std::vector<double>>();
  if (d.our_seconds.empty() || d.our_seconds.size() != d.peer_seconds.size())
    throw FormatError("our_seconds and peer_seconds: expected as many of one as of the other, at least one");
  d.our_wall_seconds = json.value("our_wall_seconds", std::vector<double>());
  d.peer_wall_seconds = json.value("peer_wall_seconds", std::vector<double>());
  d.threads = json.value("threads", std::size_t{1});
  const auto are_as_many = [&](const std::vector<double>& wall) {
    return wall.size() == d.our_seconds.size() || (wall.empty() && d.threads == 1);
  };
  if (!are_as_many(d.our_wall_seconds) || d.our_wall_seconds.size() != d.peer_wall_seconds.size())
    throw FormatError(
        "our_wall_seconds and peer_wall_seconds: expected as many as of our_seconds, or none of one thread");
  return d;
}

PlannerQuery query_of(const ordered_json& json) {
  PlannerQuery q{json.value("setting", kFirstSetting), json.at("world"), json.at("query"), json.at("lower_bound"), {}};
  for (const ordered_json& a : json.at("answers"))
    q.answers.push_back(
        {a.at("planner"), a.at("status"), a.at("seconds"), a.value("travel_time", 0.0), a.value("valid", false)});
  return q;
}

template <class Item>
std::vector<Item> items_of(const ordered_json& document, const char* key, Item (*read)(const ordered_json&),
                           const std::string& name) {
  std::vector<Item> items;
  for (const ordered_json& json : document.value(key, ordered_json::array())) {
    const std::string place = name + ": " + key + "[" + std::to_string(items.size()) + "]: ";
    try {
      items.push_back(read(json));
    } catch (const nlohmann::json::exception& error) {
      throw FormatError(place + message_of(error));
    } catch (const FormatError& error) {
      throw FormatError(place + error.what());
    }
  }
  return items;
}

template <class Item>
std::string lines_of(const std::vector<Item>& items) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "\n" : ",\n") + to_json(item).dump();
  return text + "\n";
}

/// Whether an opponent is called after what a key of the context stands for: "CGAL expansion" after "cgal".
bool is_named_by(const PeerResults& results, std::string_view key) {
  const auto is_after = [&](std::string_view name) {
    return std::ranges::equal(name.substr(0, key.size()), key, {}, [](unsigned char c) { return std::tolower(c); });
  };
  return std::ranges::any_of(results.duels, [&](const Duel& d) { return is_after(d.ours) || is_after(d.peer); }) ||
         std::ranges::any_of(results.queries, [&](const PlannerQuery& q) {
           return std::ranges::any_of(q.answers, is_after, &PlannerAnswer::planner);
         });
}

}  // namespace

bool is_peer_results(std::string_view text) {
  const ordered_json document = ordered_json::parse(text, nullptr, false);
  return document.is_object() && document.value("format", ordered_json()) == kFormat;
}

PeerResults read_peer_results(std::string_view text, std::string_view name) {
  PeerResults results;
  results.name = name;
  ordered_json document;
  try {
    document = ordered_json::parse(text);
    for (const auto& [key, value] : document.at("context").items())
      results.context.emplace_back(key, value.get<std::string>());
  } catch (const nlohmann::json::exception& error) {
    throw FormatError(results.name + ": " + message_of(error));
  }
  results.duels = items_of(document, "duels", duel_of, results.name);
  results.queries = items_of(document, "queries", query_of, results.name);
  return results;
}

std::string peer_results_json(const PeerResults& results) {
  ordered_json context = ordered_json::object();
  for (const auto& [key, value] : results.context) context[key] = value;
  return std::string("{\n\"format\": \"") + kFormat + "\", \"version\": 1,\n\"context\": " + context.dump(1) +
         ",\n\"duels\": [" + lines_of(results.duels) + "],\n\"queries\": [" + lines_of(results.queries) + "]\n}\n";
}

PeerResults renewed(const PeerResults& earlier, PeerResults run, std::span<const std::string> order) {
  PeerResults kept;
  if (run.duels.empty()) kept.duels = earlier.duels;
  std::ranges::copy_if(earlier.queries, std::back_inserter(kept.queries), [&](const PlannerQuery& q) {
    return std::ranges::find(run.queries, q.setting, &PlannerQuery::setting) == run.queries.end();
  });
  const bool keeps_any = !kept.duels.empty() || !kept.queries.empty();
  for (const auto& entry : earlier.context) {
    const std::string& key = entry.first;
    if (std::ranges::find(run.context, key, &std::pair<std::string, std::string>::first) != run.context.end()) continue;
    if (keeps_any && (is_named_by(kept, key) || !is_named_by(earlier, key))) run.context.push_back(entry);
  }
  if (run.duels.empty()) run.duels = std::move(kept.duels);
  run.queries.insert(run.queries.begin(), kept.queries.begin(), kept.queries.end());
  std::ranges::stable_sort(run.queries, {}, [&](const PlannerQuery& q) { return std::ranges::find(order, q.setting); });
  return run;
}

std::vector<PlannerQuery> answered_anew(std::span<const PlannerQuery> earlier, std::span<const PlannerQuery> run) {
  const auto key = [](const PlannerQuery& q) { return std::tie(q.setting, q.world, q.query); };
  std::vector<PlannerQuery> queries;
  std::ranges::copy_if(earlier, std::back_inserter(queries), [&](const PlannerQuery& q) {
    return std::ranges::find(run, q.setting, &PlannerQuery::setting) != run.end();
  });
  for (const PlannerQuery& anew : run) {
    const auto known = std::ranges::find_if(queries, [&](const PlannerQuery& q) { return key(q) == key(anew); });
    if (known == queries.end()) {
      queries.push_back(anew);
      continue;
    }
    std::vector<PlannerAnswer> answers = anew.answers;
    std::ranges::copy_if(known->answers, std::back_inserter(answers), [&](const PlannerAnswer& a) {
      return std::ranges::find(anew.answers, a.planner, &PlannerAnswer::planner) == anew.answers.end();
    });
    *known = anew;
    known->answers = std::move(answers);
  }
  return queries;
}

}  // namespace arcway::internal::report

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/doctor.h"
#include "arcway/datasets/geojson.h"
#include "arcway/datasets/repair.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

struct DoctorArguments {
  std::string map;
  std::string repair, json;
  bool all = false;
  MapOptions reading;
};

constexpr std::size_t kShown = 5;  // findings of a kind

std::string findings_rows(const DoctorReport& report, bool all) {
  std::map<FindingKind, std::vector<const Finding*>> kinds;
  for (const Finding& finding : report.findings) kinds[finding.kind].push_back(&finding);
  std::string text;
  for (const auto& [kind, findings] : kinds) {
    text.append("\n").append(name_of(kind)).append(": ").append(count_text(findings.size())).append("; ");
    text.append(consequence_of(kind)).append("\n");
    for (std::size_t i = 0; i < findings.size(); ++i) {
      if (!all && i == kShown && findings.size() > kShown + 1) {
        text += "  ... " + count_text(findings.size() - i) + " more; --all shows them\n";
        break;
      }
      const Finding& finding = *findings[i];
      text.append("  ").append(finding.place.empty() ? "the map" : finding.place);
      if (finding.at) text += " at (" + shortest_text(finding.at->x()) + ", " + shortest_text(finding.at->y()) + ")";
      text.append(": ").append(finding.what).append("\n");
    }
  }
  return text;
}

std::string report_json(const DoctorArguments& arguments, const DoctorReport& report, const MapFile& map) {
  nlohmann::ordered_json json{{"format", "arcway-doctor"},
                              {"version", 1},
                              {"map", arguments.map},
                              {"plans", report.plans()},
                              {"obstacles", report.obstacles},
                              {"vertices", report.vertices},
                              {"findings", nlohmann::json::array()},
                              {"warnings", map.warnings}};
  for (const Finding& finding : report.findings) {
    nlohmann::ordered_json entry{{"kind", name_of(finding.kind)}, {"place", finding.place}};
    if (finding.at) entry["at"] = {finding.at->x(), finding.at->y()};
    entry["what"] = finding.what;
    entry["planning"] = consequence_of(finding.kind);
    entry["refused"] = is_refused(finding.kind);
    json["findings"].push_back(std::move(entry));
  }
  return json.dump() + "\n";
}

int run_doctor(const DoctorArguments& arguments, std::string& out) {
  if (!arguments.repair.empty() && !can_repair())
    throw UsageError("--repair: needs GEOS, and this tool was built without it; leave it out for the report");
  OutputFiles files({arguments.json, arguments.repair}, {arguments.map});
  const MapFile map = read_named_map(arguments.map, arguments.reading, /*as_written=*/true);
  files.protect(map.files);
  const DoctorReport report = examine(map);

  if (!arguments.json.empty()) files.add(arguments.json, report_json(arguments, report, map));
  std::string repair_rows;
  if (!arguments.repair.empty()) {
    const MapFile clean = repaired(map);
    repair_rows = "\nrepaired\n" + world_rows(to_world(clean, arguments.repair));
    const auto contacts = std::ranges::count(examine(clean).findings, FindingKind::kSelfTouching, &Finding::kind);
    if (contacts > 0)
      repair_rows += row("touches itself", "kept at " + count_text(contacts) + (contacts == 1 ? " point" : " points"));
    files.add(arguments.repair, to_geojson(clean));
  }

  out += arguments.map + ": " + (report.plans() ? "plans as it is" : "REFUSED by planning") + ", " +
         (report.findings.empty()
              ? std::string("nothing found")
              : count_text(report.findings.size()) + (report.findings.size() == 1 ? " finding" : " findings")) +
         "\n";
  out += row("obstacles", count_text(report.obstacles)) + row("vertices", count_text(report.vertices));
  for (const std::string& note : map.notes) out += row("read", note);
  for (const std::string& warning : map.warnings) out += row("warning", warning);
  out += findings_rows(report, arguments.all) + repair_rows;
  files.write();
  out += files.summary();
  return report.plans() ? kExitSolved : kExitNoPath;
}

}  // namespace

void add_doctor_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("doctor",
                                          "Say what is unusual or wrong in a map, where, and what planning does "
                                          "with it; exit code 1 if planning refuses it");
  const auto arguments = std::make_shared<DoctorArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command.add_flag("--all", arguments->all, "Print all findings, not the first few of each kind");
  command.add_option("--json", arguments->json, "Write all findings")->type_name("F.json");
  command.add_option("--repair", arguments->repair, "Write a clean map: valid rings, overlaps joined (needs GEOS)")
      ->type_name("W.geojson");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_doctor(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

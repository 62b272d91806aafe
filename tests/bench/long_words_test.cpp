// Messages repeat of a word of any length no more than its beginning.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/tool.h"

namespace {

using arcway::internal::test::kAround;
using arcway::internal::test::Tool;

constexpr std::size_t kMegabyte = 1 << 20;
constexpr std::size_t kMostPrinted = 4000;      ///< of a report with a message or two
constexpr std::size_t kMostOfMessage = 10'100;  ///< names of files, as of a map, are repeated up to here

class LongWords : public Tool {
 protected:
  void expect_short(const std::string& arguments, const std::string& what, std::size_t most = kMostPrinted) const {
    const Run result = run(arguments);
    EXPECT_LT(result.out.size() + result.err.size(), most) << what;
    EXPECT_TRUE(result.code == 1 || result.code == 2) << what << "\n" << result.out << result.err;
  }
};

TEST_F(LongWords, OfMaps) {
  const std::string digits(kMegabyte, '9'), zeros(kMegabyte, '0'), letters(kMegabyte, 'x');
  const auto polygon = [](const std::string& position) {
    return R"({"type":"Polygon","coordinates":[[)" + position + ",[4,0],[4,4],[0,4]]]}";
  };
  const std::string scen = "version 1\n0 ", map_end = "\nmap\n..\n..\n";
  const std::string yaml = ": 0.05\norigin: [0,0,0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const std::vector<std::pair<std::string, std::string>> maps = {
      {"number.geojson", polygon("[" + digits + ",0]")},
      {"word.geojson", polygon("[" + letters + ",0]")},
      {"string.geojson", polygon("[\"" + letters + "\",0]")},
      {"open.geojson", polygon("[\"" + letters)},
      {"type.geojson", R"({"type":")" + letters + R"(","coordinates":[]})"},
      {"word.wkt", "POLYGON((0 0, " + letters + " 0))"},
      {"number.wkt", "POLYGON((0 0, " + digits + " 0))"},
      {"type.wkt", "POLYGON" + letters + "((0 0, 1 0, 1 1))"},
      {"text.txt", "0 0 1 0 " + letters + "\n"},
      {"list.csv", "x,y\n0,0\n1," + letters + "\n"},
      {"height.map", "type octile\nheight " + digits + "\nwidth 2" + map_end},
      {"name.scen", scen + letters + ".map 2 2 0 0 1 1 1.0\n"},
      {"cell.scen", scen + "m.map 2 2 " + zeros + "7 0 1 1 1.0\n"},
      {"length.scen", scen + "m.map 2 2 0 0 1 1 " + letters + "\n"},
      {"image.yaml", "image: " + letters.substr(0, 50000) + "\nresolution" + yaml},
      {"number.yaml", "image: a.pgm\nresolution: " + letters.substr(0, 50000) + "\norigin" + yaml},
      {"broken.yaml", "image: \"" + letters.substr(0, 50000) + "\nresolution" + yaml},
      {"width.pgm", "P2 " + digits + " 1 255 0"},
      {"path.svg", R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 )" + letters + R"("/></svg>)"},
      {"move.svg", R"(<svg xmlns="http://www.w3.org/2000/svg"><g transform=")" + letters +
                       R"("><path d="M0 0 L1 0 L1 1 Z"/></g></svg>)"},
      {"unknown.map", letters},
  };
  for (const auto& [name, text] : maps) {
    expect_short("doctor " + put(name, text), name);
    std::filesystem::remove(file(name));
  }
}

TEST_F(LongWords, OfRobotsQueriesAndPlans) {
  const std::string digits(kMegabyte, '9'), letters(kMegabyte, 'x');
  const auto robot = [&](const std::string& member) {
    expect_short("plan " + map_ + kAround + " --robot " +
                     put("r.json", R"({"format":"arcway-robot","version":1,)" + member + "}"),
                 member.substr(0, 20));
  };
  robot("\"length\":" + digits);
  robot("\"length\":\"" + letters + "\"");
  robot("\"" + letters + "\":1");
  robot("\"" + letters + "\":1,\"" + letters + "\":1");
  robot("\"steering\":\"" + letters + "\"");
  for (const std::string& line : {letters, "0,1,2,0,3,4," + letters, digits + ",1,2,0,3,4,0", "0,1,2,0,3," + letters})
    expect_short("plan " + map_ + " --out " + file("o.csv") + " --queries " +
                     put("q.csv", "q,sx,sy,stheta,gx,gy,gtheta\n" + line + "\n"),
                 line.substr(0, 20));
  const std::string plan = R"({"format":"arcway-plan","version":1,"start":[0,0,0],"goal":[0,0,0],"path":[],"status":")";
  for (const std::string& text : {plan + letters + "\"}", plan + "solved\",\"" + letters + "\":1}"})
    expect_short("validate " + map_ + " --path " + put("p.json", text), "plan");
  const std::string run_of_bench = R"({"context":{},"benchmarks":[{"name":"a","real_time":")";
  expect_short("report --out " + file("report") + " " + put("b.json", run_of_bench + letters + "\"}]}"), "report");
}

TEST_F(LongWords, OfTheCommandLine) {
  const std::string letters(100'000, 'x');
  for (const char* option : {"--start ", "--goal ", "--time-limit ", "--threads ", "--heuristic ", "--backend ",
                             "--svg-view ", "--unknown ", "--cell ", "--alternatives ", "--"})
    expect_short("plan " + map_ + " --svg " + file("p.svg") + " " + option + letters, option, kMostOfMessage);
  expect_short("plan clutter/star/n" + letters + kAround, "number of the catalog", kMostOfMessage);
  expect_short("plan clutter/" + letters + kAround, "kind of the catalog", kMostOfMessage);
  expect_short("graph " + map_ + " --kind " + letters, "--kind");
}

}  // namespace

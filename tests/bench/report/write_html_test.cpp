#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"

// The report's page as a browser shows and prints it: the kept results of a machine, by the tool. Skipped where there
// is no browser.
namespace arcway::internal::report {
namespace {

namespace fs = std::filesystem;

const fs::path kKept = fs::path(ARCWAY_SOURCE_DIR) / "bench/results/amd-epyc";
constexpr std::size_t kMostPages = 12;

// Boxes that reach beyond what holds them, as lines of text. Everything is unfolded. Half a pixel is rounding.
constexpr const char* kMeasure = R"JS(
const faults = [], slack = 0.5;
const beyond = (inner, outer) => inner.left < outer.left - slack || inner.right > outer.right + slack ||
  inner.top < outer.top - slack || inner.bottom > outer.bottom + slack;
const fault = (what, element) => faults.push(what + ': "' + element.textContent.trim().slice(0, 40) + '"');
const shown = element => element.getClientRects().length > 0;
const fits_page = () => {
  if (document.documentElement.scrollWidth > innerWidth) faults.push('page: ' + document.documentElement.scrollWidth);
  for (const e of document.querySelectorAll('body *')) {
    if (!shown(e) || e.closest('svg') || (e.closest('.scroll, pre') && !e.matches('.scroll, pre'))) continue;
    const box = e.getBoundingClientRect();
    if (box.left < -slack || box.right > innerWidth + slack) fault('beyond the page', e);
  }
};
const fits_plots = () => {
  for (const svg of document.querySelectorAll('svg')) {
    const outer = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')].filter(shown);
    for (const text of texts) if (beyond(text.getBoundingClientRect(), outer)) fault('text cut by its picture', text);
    if (svg.matches('.plot')) for (const a of texts) for (const b of texts) {
      const x = a.getBoundingClientRect(), y = b.getBoundingClientRect();
      const apart = x.right <= y.left + 1 || y.right <= x.left + 1 || x.bottom <= y.top + 3 || y.bottom <= x.top + 3;
      if (a !== b && !apart) fault('text over "' + b.textContent + '"', a);
    }
  }
  for (const figure of document.querySelectorAll('figure')) {
    const outer = figure.getBoundingClientRect();
    for (const part of figure.querySelectorAll('.legend, .legend li, .key, figcaption'))
      if (shown(part) && beyond(part.getBoundingClientRect(), outer)) fault('cut by its figure', part);
  }
};
const links_hold = () => {
  const ids = [...document.querySelectorAll('[id]')].map(e => e.id);
  ids.forEach((id, i) => { if (ids.indexOf(id) !== i) faults.push('two of the id ' + id); });
  for (const link of document.querySelectorAll('nav a'))
    if (!document.getElementById(link.hash.slice(1))) fault('leads nowhere', link);
};
const luminance = color => color.match(/[\d.]+/g).slice(0, 3).map(v => v / 255)
  .map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
  .reduce((sum, v, i) => sum + [0.2126, 0.7152, 0.0722][i] * v, 0);
const legible = () => {
  const ground = luminance(getComputedStyle(document.body).backgroundColor);
  for (const e of document.querySelectorAll('h1, h2, p, li, td, th, figcaption, .plot text')) {
    const style = getComputedStyle(e), ink = luminance(e.closest('svg') ? style.fill : style.color);
    const contrast = (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
    if (contrast < 4.5) { fault('contrast ' + contrast.toFixed(1), e); break; }
  }
};
document.querySelectorAll('details').forEach(d => d.open = true);
links_hold();
fits_page();
fits_plots();
legible();
document.getElementById('axes').click();
fits_plots();
const mark = document.querySelector('.linear [data-tip]');
mark.dispatchEvent(new PointerEvent('pointerover', {bubbles: true, clientX: innerWidth - 5, clientY: 5}));
fits_page();
parent.document.title = JSON.stringify({width: innerWidth, dark: matchMedia('(prefers-color-scheme: dark)').matches,
  ground: luminance(getComputedStyle(document.body).backgroundColor), plots: document.querySelectorAll('.plot').length,
  pictures: document.querySelectorAll('.picture svg').length, linear: document.body.className,
  tip: document.getElementById('tip').textContent, faults: [...new Set(faults)]});
)JS";

bool runs(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

class Page : public testing::Test {
 protected:
  void SetUp() override {
    const char* configured = std::getenv("ARCWAY_BROWSER");
    browser_ = configured != nullptr ? configured : "chromium";
    if (!runs(browser_ + " --version"))
      GTEST_SKIP() << "no browser \"" << browser_ << "\"; ARCWAY_BROWSER may name one";
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(name, '/', '_');
    folder_ = fs::path(testing::TempDir()) / ("arcway_page_" + std::to_string(getpid()) + "_" + name);
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  /// The page that the tool makes of files of the kept results.
  void make_page(const std::vector<std::string>& names) {
    std::string command = ARCWAY_TOOL " report";
    for (const std::string& name : names) command += " " + (kKept / name).string();
    ASSERT_TRUE(runs(command + " --out " + folder_.string())) << command;
    html_ = read_file(folder_ / "report.html");
  }

  /// Opens a page headless.
  void browse(const fs::path& page, const std::string& options) {
    const std::string command =
        browser_ + " --headless --no-sandbox --disable-gpu --user-data-dir=" + (folder_ / "profile").string() +
        " --enable-logging=stderr " + options + " file://" + page.string() + " > " + (folder_ / "out").string() +
        " 2> " + (folder_ / "log").string();
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const std::string log = read_file(folder_ / "log");
    EXPECT_EQ(log.find("CONSOLE"), std::string::npos) << log.substr(log.find("CONSOLE"), 500);
  }

  /// What the measuring script says of a copy of the page, in a frame: windows are not as narrow as telephones.
  nlohmann::json measured(int width, bool dark) {
    write_file_atomically(folder_ / "measured.html", html_ + "<script>" + kMeasure + "</script>");
    write_file_atomically(folder_ / "frame.html",
                          "<!DOCTYPE html><style>:root { color-scheme: light dark; }</style><iframe width=\"" +
                              std::to_string(width) +
                              "\" height=\"900\" style=\"border: 0\" src=\"measured.html\"></iframe>");
    browse(folder_ / "frame.html", "--dump-dom --allow-file-access-from-files --window-size=1400,1000" +
                                       std::string(dark ? " --blink-settings=preferredColorScheme=0" : ""));
    const std::string dom = read_file(folder_ / "out");
    const std::size_t begin = dom.find("<title>") + 7;
    return nlohmann::json::parse(dom.substr(begin, dom.find("</title>") - begin));
  }

  void expect_fit(int width, bool dark) {
    const nlohmann::json found = measured(width, dark);
    EXPECT_EQ(found["width"], width);
    EXPECT_EQ(found["dark"], dark);
    EXPECT_EQ(found["ground"] < 0.1, dark) << "the page's ground does not follow the theme";
    EXPECT_EQ(found["linear"], "linear-axes");
    EXPECT_NE(found["tip"], "");
    EXPECT_GT(found["plots"], 2);
    EXPECT_EQ(found["faults"].size(), 0u) << found["faults"].dump(1);
  }

  std::string browser_, html_;
  fs::path folder_;
};

struct Screen {
  int width;
  bool dark;
};

class PageOnScreen : public Page, public testing::WithParamInterface<Screen> {};

TEST_P(PageOnScreen, CutsNothingOff) {
  ASSERT_NO_FATAL_FAILURE(make_page({"results.json", "peers.json"}));
  EXPECT_NE(html_.find("<figure class=\"picture\">"), std::string::npos);
  expect_fit(GetParam().width, GetParam().dark);
}

std::string name_of(const testing::TestParamInfo<Screen>& screen) {
  return std::to_string(screen.param.width) + (screen.param.dark ? "Dark" : "Light");
}

INSTANTIATE_TEST_SUITE_P(Report, PageOnScreen,
                         testing::Values(Screen{1280, false}, Screen{1280, true}, Screen{400, false},
                                         Screen{400, true}),
                         name_of);

TEST_F(Page, OfAComparisonCutsNothingOff) {
  ASSERT_NO_FATAL_FAILURE(make_page({"results.json", "results.json"}));
  EXPECT_NE(html_.find("Before: results.json, commit "), std::string::npos);
  expect_fit(400, false);
}

/// The text of each page of a PDF.
std::vector<std::string> pages_of(const fs::path& pdf, const fs::path& text) {
  if (!runs("pdftotext -layout " + pdf.string() + " " + text.string())) return {};
  std::istringstream all(read_file(text));
  std::vector<std::string> pages;
  for (std::string page; std::getline(all, page, '\f');) pages.push_back(page);
  return pages;
}

std::string last_line(const std::string& page) {
  std::istringstream lines(page);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t") != std::string::npos) last = line.substr(line.find_first_not_of(" \t"));
  return last;
}

TEST_F(Page, PrintsOnFewPagesAndEndsNoneWithAHeading) {
  ASSERT_NO_FATAL_FAILURE(make_page({"results.json", "peers.json"}));
  const fs::path pdf = folder_ / "report.pdf";
  ASSERT_NO_FATAL_FAILURE(browse(folder_ / "report.html", "--no-pdf-header-footer --print-to-pdf=" + pdf.string()));
  const std::string bytes = read_file(pdf);
  const std::regex page("/Type ?/Page[^s]");
  const auto count = std::distance(std::sregex_iterator(bytes.begin(), bytes.end(), page), std::sregex_iterator());
  EXPECT_GE(count, 2);
  EXPECT_LE(static_cast<std::size_t>(count), kMostPages);
  const std::vector<std::string> pages = pages_of(pdf, folder_ / "text");
  if (pages.empty()) GTEST_SKIP() << "no pdftotext: " << count << " pages, their texts were not read";
  ASSERT_EQ(pages.size(), static_cast<std::size_t>(count));
  for (const std::string& text : pages) {
    const std::string last = last_line(text);
    EXPECT_GT(std::ranges::count(text, '\n'), 8) << "a page with next to nothing: " << text;
    EXPECT_EQ(html_.find(">" + last + "</h2>"), std::string::npos) << "a page ends with the heading " << last;
  }
  EXPECT_NE(pages.back().find("Not printed: "), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::report

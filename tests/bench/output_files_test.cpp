// What the tool does to files: with real signals, limits and mounts.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/tool.h"

namespace {

namespace fs = std::filesystem;

using arcway::internal::test::kAround;
using arcway::internal::test::text_of;
using arcway::internal::test::Tool;

class OutputFilesTest : public Tool {
 protected:
  std::string plan() const { return "plan " + map_ + kAround; }
  std::string command(const std::string& arguments) const { return "\"" ARCWAY_TOOL "\" " + arguments; }

  [[nodiscard]] std::vector<std::string> temporaries() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".tmp") names.push_back(entry.path().filename());
    return names;
  }

  // A tool that has written p.json beside its place, and waits for somebody to read the pipe; ended by this signal.
  int status_when_sent(int signal) const {
    const std::string json = file("p.json"), pipe = file("pipe"), start = "10,10,0", goal = "50,50,90deg";
    const pid_t child = fork();
    if (child == 0) {
      freopen("/dev/null", "w", stdout);
      freopen("/dev/null", "w", stderr);
      execl(ARCWAY_TOOL, ARCWAY_TOOL, "plan", map_.c_str(), "--start", start.c_str(), "--goal", goal.c_str(), "--json",
            json.c_str(), "--csv", pipe.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    constexpr std::chrono::seconds kPatience(60);
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    const auto waits_for_reader = [&] {
      const std::vector<std::string> names = temporaries();
      return std::any_of(names.begin(), names.end(),
                         [&](const std::string& name) { return text_of(folder_ / name).ends_with("}\n"); });
    };
    while (!waits_for_reader() && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // A signal that comes before the tool waits is only remembered: on a busy machine it is sent again.
    int status = 0;
    do {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      kill(child, signal);
    } while (waitpid(child, &status, WNOHANG) == 0 && std::chrono::steady_clock::now() < give_up);
    return status;
  }
};

TEST_F(OutputFilesTest, ASignalLeavesNeitherHalfNorTemporaryFiles) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(strsignal(signal));
    put("p.json", "old");
    fs::remove(file("pipe"));
    ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
    const int status = status_when_sent(signal);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(read("p.json"), "old");
    EXPECT_TRUE(temporaries().empty());
  }
}

TEST_F(OutputFilesTest, ALimitOfSizesIsAnErrorThatLeavesNothing) {
  put("w.geojson", "old");
  const Run result = run_command("ulimit -f 8; " + command("generate rooms/v2000 --out " + file("w.geojson") +
                                                           " --queries " + file("q.csv") + " --count 2"));
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("w.geojson: File too large"), std::string::npos) << result.err;
  EXPECT_EQ(read("w.geojson"), "old");
  EXPECT_FALSE(exists("q.csv"));
  EXPECT_TRUE(temporaries().empty());
}

TEST_F(OutputFilesTest, AFullDiskIsAnErrorThatLeavesNothing) {
  const std::string disk = file("disk");
  fs::create_directory(disk);
  const std::string mount = "mount -t tmpfs -o size=64k none " + disk + " && echo old >" + disk + "/w.geojson && ";
  if (run_command("unshare -m sh -c '" + mount + "true'").code != 0) GTEST_SKIP() << "mounts are not allowed here";
  const Run result =
      run_command("unshare -m sh -c '" + mount + command("generate rooms/v20000 --out " + disk + "/w.geojson") +
                  "; echo $?; ls -A " + disk + "; cat " + disk + "/w.geojson'");
  EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "2\nw.geojson\nold\n");
}

TEST_F(OutputFilesTest, AMountPointIsRefusedBeforeAnythingIsWritten) {
  put("p.json", "old"), put("p.csv", "old"), put("other", "mounted");
  const std::string mount = "mount --bind " + file("other") + " " + file("p.csv") + " && ";
  if (run_command("unshare -m sh -c '" + mount + "true'").code != 0) GTEST_SKIP() << "mounts are not allowed here";
  const Run result = run_command("unshare -m sh -c '" + mount +
                                 command(plan() + " --json " + file("p.json") + " --csv " + file("p.csv")) + "'");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("p.csv: a file system is mounted there"), std::string::npos) << result.err;
  EXPECT_EQ(read("p.json") + read("p.csv") + read("other"), "oldoldmounted");
  EXPECT_TRUE(temporaries().empty());
}

TEST_F(OutputFilesTest, WhatCannotBeWrittenIsFoundBeforeTheWork) {
  const std::string none = file("no_such_map.geojson"), wrong = file("no/such/folder/f");
  put("m.arcway", "");
  for (const std::string& arguments :
       {"plan " + none + kAround + " --json ", "plan " + none + kAround + " --svg ", "graph " + none + " --edges ",
        "prepare " + none + " --out ", "doctor " + none + " --json ", "change " + none + " --remove 0 --out ",
        std::string("generate no/such/world --out ")}) {
    expect_bad_input(arguments + wrong, "cannot write " + wrong + ": No such file");
    expect_bad_input(arguments + folder_.string(), "cannot write " + folder_.string() + ": Is a directory");
  }
  expect_bad_input("convert " + none + " " + wrong + ".wkt", "cannot write " + wrong + ".wkt: No such file");
}

TEST_F(OutputFilesTest, NoFileOfAMapIsReplaced) {
  const std::string data = ARCWAY_SOURCE_DIR "/tests/data/";
  for (const char* name : {"room.yaml", "room.pgm", "rooms.map", "rooms.map.scen"})
    fs::copy_file(data + name, file(name));
  const std::string message = "was read, and would be replaced by what is written";
  for (const char* name : {"room.yaml", "room.pgm"}) {
    fs::create_symlink(name, file("link"));
    for (const std::string& target : {file(name), file("./") + name, file("link")}) {
      const std::string read_map = " " + file("room.yaml") + " ";
      expect_bad_input("plan" + read_map + "--start 0,2.5,0 --goal 4,6,180deg --svg " + target, message);
      expect_bad_input("graph" + read_map + "--edges " + target, message);
      expect_bad_input("prepare" + read_map + "--out " + target, message);
      expect_bad_input("doctor" + read_map + "--json " + target, message);
    }
    fs::remove(file("link"));
    EXPECT_EQ(read(name), text_of(data + name));
  }
  fs::create_hard_link(file("rooms.map"), file("hard.wkt"));
  expect_bad_input("convert " + file("rooms.map.scen") + " " + file("hard.wkt"), message);
  expect_bad_input("doctor " + file("rooms.map.scen") + " --json " + file("rooms.map"), message);
  EXPECT_EQ(read("rooms.map"), text_of(data + "rooms.map"));

  ASSERT_EQ(run("prepare " + map_ + " --kind reduced --out " + file("m.arcway")).code, 0);
  const std::string change = "change " + file("m.arcway") + " --out ";
  expect_bad_input(change + file("m.arcway") + " --remove 0", message);
  expect_bad_input(change + file("room.pgm") + " --add " + file("room.yaml"), message);
  EXPECT_EQ(run(change + file("n.arcway") + " --remove 0").code, 0);
}

TEST_F(OutputFilesTest, StandardOutputMayBeAFile) {
  const Run both = run(plan() + " --json /dev/stdout");  // which run() sends to a file
  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_TRUE(both.out.starts_with("{\"format\":\"arcway-plan\"")) << both.out;
  EXPECT_NE(both.out.find("travel time"), std::string::npos);
  for (const char* two : {" --json - --csv -", " --json - --csv /dev/stdout"})
    expect_bad_input(plan() + two, "two files are to be written to standard output");
  const Run one = run(plan() + " --json " + file("stdout"));
  EXPECT_EQ(one.code, 2);
  EXPECT_NE(one.err.find("takes what is printed"), std::string::npos) << one.err;
  EXPECT_EQ(run(plan() + " --json /dev/null --csv /dev/null --svg /dev/stderr").code, 0);
  EXPECT_EQ(run_command(command(plan() + " --json /dev/fd/3") + " 3>" + file("three")).code, 0);
  EXPECT_TRUE(read("three").starts_with("{\"format\":\"arcway-plan\""));
}

}  // namespace

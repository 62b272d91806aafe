#include "arcway/datasets/prepared_map.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "arcway/datasets/geojson.h"
#include "arcway/datasets/robot.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway {

using namespace internal;
namespace {

static_assert(std::endian::native == std::endian::little, "files hold numbers as memory does, lowest byte first");

constexpr std::string_view kMagic =
    "\x89"
    "ARCWAY\n";
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kHasBounds = 1;
constexpr std::uint64_t kAlignment = 64;
constexpr std::uint32_t kMaxSections = 64;

// Sections that are no SnapshotArray.
constexpr std::uint32_t kStart = 101, kGoal = 102, kRobot = 103, kZones = 104;

struct Header {
  std::array<char, 8> magic;
  std::uint32_t byte_order, version, flags, sections;
  std::uint64_t file_bytes;
  std::uint32_t section_table_crc, header_crc;  // checksum of all bytes before it
};
static_assert(sizeof(Header) == 40 && std::is_trivially_copyable_v<Header>);

struct Entry {
  std::uint32_t id, crc;
  std::uint64_t offset, count;
  std::uint32_t element_bytes, reserved;  // 0
};
static_assert(sizeof(Entry) == 32 && std::is_trivially_copyable_v<Entry>);

std::uint32_t crc_of(const void* bytes, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(0, static_cast<const Bytef*>(bytes), size));
}

std::uint64_t aligned(std::uint64_t offset) { return (offset + kAlignment - 1) / kAlignment * kAlignment; }

class Writer {
 public:
  template <class T>
  void add(std::uint32_t id, std::span<const T> values) {
    sections_.push_back({{id, crc_of(values.data(), values.size_bytes()), 0, values.size(), sizeof(T), 0},
                         reinterpret_cast<const char*>(values.data())});
  }
  template <class T>
  void add(SnapshotArray array, const std::vector<T>& values) {
    add(static_cast<std::uint32_t>(array), std::span<const T>(values));
  }

  std::string bytes(std::uint32_t flags) {
    std::uint64_t end = sizeof(Header) + sections_.size() * sizeof(Entry);
    std::vector<Entry> entries;
    for (auto& [entry, data] : sections_) {
      entry.offset = aligned(end);
      end = entry.offset + entry.count * entry.element_bytes;
      entries.push_back(entry);
    }
    Header header{{}, kByteOrder, kVersion, flags, static_cast<std::uint32_t>(entries.size()), end, 0, 0};
    kMagic.copy(header.magic.data(), header.magic.size());
    header.section_table_crc = crc_of(entries.data(), entries.size() * sizeof(Entry));
    header.header_crc = crc_of(&header, offsetof(Header, header_crc));
    std::string bytes;
    bytes.reserve(end);
    bytes.append(reinterpret_cast<const char*>(&header), sizeof header);
    bytes.append(reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(Entry));
    for (const auto& [entry, data] : sections_) {
      bytes.resize(entry.offset);
      bytes.append(data, entry.count * entry.element_bytes);
    }
    return bytes;
  }

 private:
  struct Section {
    Entry entry;
    const char* data;
  };
  std::vector<Section> sections_;
};

class PreparedReader {
 public:
  PreparedReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {
    read_header();
    read_entries();
  }

  [[nodiscard]] std::uint32_t flags() const { return header_.flags; }

  /// The values of a section, if there is one.
  template <class T>
  std::optional<std::vector<T>> find(std::uint32_t id) {
    const auto at = entries_.find(id);
    if (at == entries_.end()) return std::nullopt;
    const auto& [entry, place] = at->second;
    if (entry.element_bytes != sizeof(T))
      fail(place + offsetof(Entry, element_bytes), "section " + std::to_string(id) + " has elements of " +
                                                       std::to_string(entry.element_bytes) + " bytes, expected " +
                                                       std::to_string(sizeof(T)));
    std::vector<T> values(entry.count);
    // Eigen's points are plain pairs of doubles, though not trivial by the letter.
    if (entry.count > 0)
      std::memcpy(static_cast<void*>(values.data()), bytes_.data() + entry.offset, entry.count * sizeof(T));
    entries_.erase(at);
    return values;
  }
  template <class T>
  std::vector<T> get(std::uint32_t id) {
    std::optional<std::vector<T>> values = find<T>(id);
    if (!values) fail(sizeof(Header), "section " + std::to_string(id) + " is missing");
    return std::move(*values);
  }
  template <class T>
  std::vector<T> get(SnapshotArray array) {
    note_place(array);
    return get<T>(static_cast<std::uint32_t>(array));
  }
  /// The values of an optional section; empty if it is left out.
  template <class T>
  std::vector<T> get_or_none(SnapshotArray array) {
    const auto id = static_cast<std::uint32_t>(array);
    if (const auto at = entries_.find(id); at != entries_.end() && at->second.entry.count == 0)
      fail(at->second.place + offsetof(Entry, count), "section " + std::to_string(id) + " is empty, not left out");
    note_place(array);
    return find<T>(id).value_or(std::vector<T>{});
  }
  std::optional<Pose> pose(std::uint32_t id) {
    const std::optional<std::vector<double>> numbers = find<double>(id);
    if (!numbers) return std::nullopt;
    if (numbers->size() != 3)
      fail(sizeof(Header),
           "section " + std::to_string(id) + " has " + std::to_string(numbers->size()) + " numbers, expected a pose");
    return Pose{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }
  void expect_no_more() const {
    if (!entries_.empty())
      fail(entries_.begin()->second.place, "unknown section " + std::to_string(entries_.begin()->first));
  }
  [[nodiscard]] std::map<SnapshotArray, PreparedMap::Source::Section> take_places() { return std::move(places_); }

 private:
  void note_place(SnapshotArray array) {
    if (const auto at = entries_.find(static_cast<std::uint32_t>(array)); at != entries_.end())
      places_[array] = {at->second.entry.offset, at->second.entry.element_bytes};
  }

  [[noreturn]] void fail(std::uint64_t byte, const std::string& what) const {
    throw FormatError(std::string(name_) + ": byte " + std::to_string(byte) + ": " + what);
  }

  void read_header() {
    if (!is_prepared_map(bytes_)) fail(0, "this is no prepared map");
    if (bytes_.size() < sizeof header_)
      fail(bytes_.size(), "the file ends in its header of " + std::to_string(sizeof header_) + " bytes");
    std::memcpy(&header_, bytes_.data(), sizeof header_);
    if (header_.byte_order != kByteOrder)
      fail(offsetof(Header, byte_order), "written by a machine of another byte order: " + hex(header_.byte_order));
    if (header_.version != kVersion)
      fail(offsetof(Header, version), "version " + std::to_string(header_.version) + ", this program reads version " +
                                          std::to_string(kVersion) + "; prepare the map again");
    expect_crc(offsetof(Header, header_crc), header_.header_crc, 0, offsetof(Header, header_crc), "the header");
    if (header_.file_bytes != bytes_.size())
      fail(bytes_.size(), "the file has " + std::to_string(bytes_.size()) + " bytes, its header says " +
                              std::to_string(header_.file_bytes));
    if (header_.flags & ~kHasBounds) fail(offsetof(Header, flags), "unknown flags " + hex(header_.flags));
  }

  void read_entries() {
    const std::uint64_t size = std::uint64_t{header_.sections} * sizeof(Entry);
    if (header_.sections > kMaxSections || sizeof header_ + size > bytes_.size())
      fail(offsetof(Header, sections),
           std::to_string(header_.sections) + " sections, at most " + std::to_string(kMaxSections) + " fit");
    expect_crc(offsetof(Header, section_table_crc), header_.section_table_crc, sizeof header_, size,
               "the table of sections");
    std::uint64_t end = sizeof header_ + size;
    for (std::uint64_t place = sizeof header_; place < sizeof header_ + size; place += sizeof(Entry)) {
      Entry entry;
      std::memcpy(&entry, bytes_.data() + place, sizeof entry);
      const std::string section = "section " + std::to_string(entry.id);
      if (entry.reserved != 0)
        fail(place + offsetof(Entry, reserved), section + " has " + hex(entry.reserved) + " where 0 is expected");
      const std::uint64_t begin = aligned(end);
      if (entry.offset != begin)
        fail(place + offsetof(Entry, offset),
             section + " begins at " + std::to_string(entry.offset) + ", expected " + std::to_string(begin));
      if (entry.element_bytes == 0 || begin > bytes_.size() ||
          entry.count > (bytes_.size() - begin) / entry.element_bytes)
        fail(place + offsetof(Entry, count), section + " has " + std::to_string(entry.count) + " elements of " +
                                                 std::to_string(entry.element_bytes) + " bytes, the file ends at " +
                                                 std::to_string(bytes_.size()));
      for (std::uint64_t padding = end; padding < begin; ++padding)
        if (bytes_[padding] != 0) fail(padding, "a byte between sections is not 0");
      end = begin + entry.count * entry.element_bytes;
      expect_crc(place + offsetof(Entry, crc), entry.crc, begin, end - begin, section);
      if (!entries_.emplace(entry.id, Found{entry, place}).second) fail(place, section + " comes twice");
    }
    if (end != bytes_.size()) fail(end, "bytes after the last section");
  }

  void expect_crc(std::uint64_t place, std::uint32_t said, std::uint64_t begin, std::uint64_t size,
                  const std::string& what) const {
    const std::uint32_t found = crc_of(bytes_.data() + begin, size);
    if (found != said)
      fail(place, "the checksum of " + what + ", bytes " + std::to_string(begin) + " to " +
                      std::to_string(begin + size) + ", is " + hex(found) + " and not " + hex(said) +
                      ": the file is damaged");
  }

  static std::string hex(std::uint32_t value) {
    std::string text = "0x";
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15];
    return text;
  }

  std::string_view bytes_;
  std::string_view name_;
  Header header_;
  struct Found {
    Entry entry;
    std::uint64_t place;  // offset of the entry
  };
  std::map<std::uint32_t, Found> entries_;
  std::map<SnapshotArray, PreparedMap::Source::Section> places_;
};

WorldSnapshot read_world(PreparedReader& reader, std::string_view name) {
  WorldSnapshot snapshot;
  snapshot.vertices = reader.get<Vec2>(SnapshotArray::kVertices);
  snapshot.next = reader.get<std::uint32_t>(SnapshotArray::kNext);
  snapshot.covered = reader.get<std::uint8_t>(SnapshotArray::kCovered);
  snapshot.ring_starts = reader.get<std::uint32_t>(SnapshotArray::kRingStarts);
  snapshot.region_rings = reader.get<std::uint32_t>(SnapshotArray::kRegionRings);
  snapshot.self_contacts = reader.get_or_none<SelfContact>(SnapshotArray::kSelfContacts);
  snapshot.has_bounds = (reader.flags() & kHasBounds) != 0;
  if (const std::optional<std::vector<char>> zones = reader.find<char>(kZones))
    snapshot.zones = read_geojson(std::string_view(zones->data(), zones->size()), std::string(name) + ", zones").zones;
  snapshot.keep_outs = reader.get_or_none<std::uint32_t>(SnapshotArray::kKeepOuts);
  return snapshot;
}

std::optional<PreparedMap::ForRobot> read_for_robot(PreparedReader& reader, std::string_view name) {
  const std::optional<std::vector<char>> robot_text = reader.find<char>(kRobot);
  if (!robot_text) return std::nullopt;
  PreparedMap::ForRobot robot;
  robot.parameters =
      read_robot(std::string_view(robot_text->data(), robot_text->size()), std::string(name) + ", robot");
  robot.radii = reader.get<double>(SnapshotArray::kRadii);
  robot.feasible.interval_starts = reader.get<std::uint64_t>(SnapshotArray::kIntervalStarts);
  robot.feasible.intervals = reader.get<HeadingInterval>(SnapshotArray::kIntervals);
  robot.feasible.link_starts = reader.get<std::uint64_t>(SnapshotArray::kLinkStarts);
  robot.feasible.links = reader.get<FeasibleGraph::Link>(SnapshotArray::kLinks);
  robot.feasible.link_counts = reader.get<LinkCounts>(SnapshotArray::kLinkCounts);
  return robot;
}

}  // namespace

std::string PreparedMap::Source::complaint(const SnapshotError& error) const {
  std::string text = name;
  if (const auto at = sections.find(error.array()); at != sections.end())
    text += ": byte " + std::to_string(at->second.offset + error.index() * at->second.element_bytes);
  return text + ": " + error.what();
}

bool is_prepared_map(std::string_view bytes) { return bytes.starts_with(kMagic); }

bool is_prepared_map_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, kMagic.size()> begin{};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return is_prepared_map({begin.data(), begin.size()});
}

PreparedMap read_prepared_map(std::string_view bytes, std::string_view name) {
  PreparedReader reader(bytes, name);
  WorldSnapshot world = read_world(reader, name);
  auto row_starts = reader.get<std::uint64_t>(SnapshotArray::kRowStarts);
  auto targets = reader.get<VertexId>(SnapshotArray::kTargets);
  const std::optional<Pose> start = reader.pose(kStart), goal = reader.pose(kGoal);
  std::optional<PreparedMap::ForRobot> robot = read_for_robot(reader, name);
  reader.expect_no_more();
  PreparedMap::Source source{std::string(name), reader.take_places()};
  try {
    return {World::from_snapshot(std::move(world)),
            VisibilityGraph(std::move(row_starts), std::move(targets)),
            start,
            goal,
            std::move(robot),
            source};
  } catch (const SnapshotError& error) {
    throw FormatError(source.complaint(error));
  } catch (const std::invalid_argument& error) {  // of the world, or of a zone
    throw FormatError(source.name + ": " + error.what());
  }
}

PreparedMap read_prepared_map_file(const std::filesystem::path& path) {
  return read_prepared_map(read_file(path, std::numeric_limits<std::size_t>::max()), path.string());
}

PreparedMap prepared_map_of(const Planner& planner, const std::optional<Pose>& start, const std::optional<Pose>& goal) {
  PreparedGraph graphs = planner.prepared_graph();
  return {planner.world(),
          std::move(graphs.reduced_graph),
          start,
          goal,
          PreparedMap::ForRobot{planner.vehicle().parameters(), std::move(graphs.radii), std::move(graphs.feasible)},
          {}};
}

std::string to_bytes(const PreparedMap& map) {
  Writer writer;
  const WorldSnapshot world = map.world.snapshot();
  writer.add(SnapshotArray::kVertices, world.vertices);
  writer.add(SnapshotArray::kNext, world.next);
  writer.add(SnapshotArray::kCovered, world.covered);
  writer.add(SnapshotArray::kRingStarts, world.ring_starts);
  writer.add(SnapshotArray::kRegionRings, world.region_rings);
  if (!world.self_contacts.empty()) writer.add(SnapshotArray::kSelfContacts, world.self_contacts);
  std::string zones;
  if (!world.zones.empty()) {
    MapFile all_zones;
    all_zones.zones = world.zones;
    zones = to_geojson(all_zones);
    writer.add(kZones, std::span<const char>(zones));
  }
  if (!world.keep_outs.empty()) writer.add(SnapshotArray::kKeepOuts, world.keep_outs);
  writer.add(static_cast<std::uint32_t>(SnapshotArray::kRowStarts), map.reduced_graph.row_starts());
  writer.add(static_cast<std::uint32_t>(SnapshotArray::kTargets), map.reduced_graph.targets());
  const auto numbers = [](const std::optional<Pose>& pose) {
    return pose ? std::vector<double>{pose->x, pose->y, pose->heading} : std::vector<double>{};
  };
  const std::vector<double> start = numbers(map.start), goal = numbers(map.goal);
  if (map.start) writer.add(kStart, std::span<const double>(start));
  if (map.goal) writer.add(kGoal, std::span<const double>(goal));
  std::string robot;
  if (map.robot) {
    robot = to_json(map.robot->parameters);
    writer.add(kRobot, std::span<const char>(robot));
    writer.add(SnapshotArray::kRadii, map.robot->radii);
    writer.add(SnapshotArray::kIntervalStarts, map.robot->feasible.interval_starts);
    writer.add(SnapshotArray::kIntervals, map.robot->feasible.intervals);
    writer.add(SnapshotArray::kLinkStarts, map.robot->feasible.link_starts);
    writer.add(SnapshotArray::kLinks, map.robot->feasible.links);
    writer.add(SnapshotArray::kLinkCounts, map.robot->feasible.link_counts);
  }
  return writer.bytes(world.has_bounds ? kHasBounds : 0);
}

void write_prepared_map(const std::filesystem::path& path, const PreparedMap& map) {
  write_file_atomically(path, to_bytes(map));
}

}  // namespace arcway

#include "arcway/zone.h"

#include <algorithm>
#include <array>
#include <variant>

namespace arcway {

bool KeepOut::is_for(std::string_view vehicle) const {
  return vehicles.empty() || std::ranges::find(vehicles, vehicle) != vehicles.end();
}

const char* role_of(const Zone& zone) {
  constexpr std::array<const char*, std::variant_size_v<ZoneRule>> kRoles{"keepout", "speed_limit", "one_way",
                                                                          "clearance"};
  return kRoles[zone.rule.index()];
}

std::string zone_text(const Zone& zone, std::size_t index) {
  const std::string role = role_of(zone);
  return zone.name.empty() ? "zone " + std::to_string(index) + " (" + role + ")" : role + " zone \"" + zone.name + "\"";
}

}  // namespace arcway

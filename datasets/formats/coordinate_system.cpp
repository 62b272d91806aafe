#include "datasets/formats/coordinate_system.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <ranges>

#include "arcway/angle.h"
#include "datasets/formats/epsg_codes.h"
#include "datasets/io/lowercase.h"
#include "datasets/io/number_text.h"

namespace arcway::internal::detail {
namespace {

constexpr double kEquatorRadius = 6378137.0;  // radius of Web Mercator's sphere [m]

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool has_any(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

// The first number of 4 to 6 digits: versions of a registry are shorter.
std::optional<int> code_in(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (!is_digit(text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end - at >= 4 && end - at <= 6) {
      int code = 0;
      std::from_chars(text.data() + at, text.data() + end, code);
      return code;
    }
    at = end;
  }
  return std::nullopt;
}

bool lies_in(int code, const auto& ranges) {
  return std::ranges::any_of(ranges, [&](const EpsgRange& r) { return r.first <= code && code <= r.last; });
}
bool is_one_of(int code, const auto& codes) { return std::ranges::find(codes, code) != std::end(codes); }

CoordinateUnit unit_of_code(int code) {
  constexpr int kFirstProjected = 2000, kLastCode = 32767;  // EPSG codes
  constexpr EpsgRange kEsriGeographic[] = {{37001, 37260}, {104000, 104999}};
  constexpr EpsgRange kEsriWorld[] = {{53001, 53099}, {54001, 54099}};
  if (is_one_of(code, kWebMercatorCodes)) return CoordinateUnit::kWebMercator;
  if (is_one_of(code, kMercatorCodes)) return CoordinateUnit::kMercator;
  if (is_one_of(code, kStretchedCodes) || lies_in(code, kEsriWorld)) return CoordinateUnit::kStretched;
  if (is_one_of(code, kGradCodes)) return CoordinateUnit::kGrads;
  if (is_one_of(code, kGeocentricCodes)) return CoordinateUnit::kGeocentric;
  if (lies_in(code, kGeographicCodes) || lies_in(code, kEsriGeographic)) return CoordinateUnit::kDegrees;
  if (lies_in(code, kOtherUnitCodes)) return CoordinateUnit::kOtherUnit;
  if (lies_in(code, kLaterCodes)) return CoordinateUnit::kUnknown;
  return code >= kFirstProjected && code <= kLastCode ? CoordinateUnit::kMeters : CoordinateUnit::kUnknown;
}

// Mercator's projection by its name, other than the transverse and the oblique one.
std::optional<CoordinateUnit> mercator_of(std::string_view text) {
  if (has_any(text, {"pseudo-mercator", "pseudo_mercator", "pseudo mercator", "web mercator", "web_mercator",
                     "webmercator", "popular visualisation", "auxiliary_sphere", "google"}))
    return CoordinateUnit::kWebMercator;
  if (has_any(text, {"mercator"}) && !has_any(text, {"transverse", "oblique", "hotine", "utm", "laborde"}))
    return CoordinateUnit::kMercator;
  return std::nullopt;
}

// WKT: the last unit is that of the axes. {"LENGTHUNIT["meter",1]"} is 1.
CoordinateUnit unit_of_planar_wkt(std::string_view wkt) {
  const std::size_t unit = wkt.rfind("unit[");
  if (unit == std::string_view::npos) return CoordinateUnit::kMeters;
  const std::size_t comma = wkt.find(',', unit);
  if (comma == std::string_view::npos) return CoordinateUnit::kUnknown;
  std::string_view rest = wkt.substr(comma + 1);
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  const std::optional<double> meters = take_number(rest);
  return meters && *meters == 1.0 ? CoordinateUnit::kMeters : CoordinateUnit::kOtherUnit;
}

std::optional<CoordinateUnit> unit_of_wkt(std::string_view text) {
  if (has_any(text, {"projcs[", "projcrs[", "projectedcrs["}))
    return mercator_of(text).value_or(unit_of_planar_wkt(text));
  if (has_any(text, {"local_cs[", "engcrs[", "engineeringcrs["})) return unit_of_planar_wkt(text);
  if (has_any(text, {"geoccs[", "cs[cartesian,3", "cs[cartesian, 3"})) return CoordinateUnit::kGeocentric;
  if (has_any(text, {"geogcs[", "geogcrs[", "geographiccrs[", "geodcrs[", "geodeticcrs["}))
    return has_any(text, {"unit[\"grad\"", "unit[\"gon\""}) ? CoordinateUnit::kGrads : CoordinateUnit::kDegrees;
  return std::nullopt;
}

std::optional<CoordinateUnit> unit_of_proj(std::string_view text) {
  if (!has_any(text, {"proj="})) return std::nullopt;
  if (has_any(text, {"proj=longlat", "proj=latlong", "proj=lonlat", "proj=latlon"})) return CoordinateUnit::kDegrees;
  if (has_any(text, {"proj=webmerc"})) return CoordinateUnit::kWebMercator;
  if (has_any(text, {"proj=merc"}))
    return has_any(text, {"+b=6378137", "nadgrids=@null"}) ? CoordinateUnit::kWebMercator : CoordinateUnit::kMercator;
  if (has_any(text, {"proj=eqc", "proj=cea", "proj=mill", "proj=robin", "proj=moll", "proj=sinu", "proj=eqearth"}))
    return CoordinateUnit::kStretched;
  if (has_any(text, {"units=us-ft", "units=ft", "units=km", "units=yd", "units=ch", "units=link", "to_meter="}))
    return CoordinateUnit::kOtherUnit;
  return has_any(text, {"proj=geocent", "proj=cart"}) ? CoordinateUnit::kGeocentric : CoordinateUnit::kMeters;
}

// The names of EPSG: projected systems are "datum / projection"; geographic ones have that of the datum alone.
CoordinateUnit unit_of_name(std::string_view text) {
  if (const auto mercator = mercator_of(text)) return *mercator;
  if (text.find(" / ") != std::string_view::npos || has_any(text, {"utm"}))
    return has_any(text, {"(ft", "ftus", "feet", "foot"}) ? CoordinateUnit::kOtherUnit : CoordinateUnit::kMeters;
  std::string plain;
  for (const char c : text)
    if (is_digit(c) || (c >= 'a' && c <= 'z')) plain += c;
  for (const std::string_view local :
       {"local", "planar", "map", "engineering", "cartesian", "meter", "meters", "meter", "meters", "m"})
    if (plain == local) return CoordinateUnit::kMeters;
  for (const std::string_view datum : {"crs84",
                                       "crs83",
                                       "crs27",
                                       "ogccrs84",
                                       "wgs84",
                                       "wgs72",
                                       "wgs1984",
                                       "gcs",
                                       "nad83",
                                       "nad27",
                                       "etrs89",
                                       "etrf",
                                       "ed50",
                                       "gda94",
                                       "gda2020",
                                       "itrf",
                                       "igs",
                                       "jgd20",
                                       "tokyo",
                                       "cgcs2000",
                                       "chinageodetic",
                                       "beijing1954",
                                       "xian1980",
                                       "sirgas",
                                       "sad69",
                                       "rgf93",
                                       "osgb36",
                                       "dhdn",
                                       "pulkovo",
                                       "nzgd",
                                       "korea2000",
                                       "gcj02",
                                       "lonlat",
                                       "longlat",
                                       "latlon",
                                       "latlong",
                                       "longitudelatitude",
                                       "longitudeandlatitude",
                                       "latitudelongitude",
                                       "geographic",
                                       "geodetic",
                                       "degree"})
    if (plain.starts_with(datum)) return CoordinateUnit::kDegrees;
  return CoordinateUnit::kUnknown;
}

}  // namespace

CoordinateUnit coordinate_unit(std::string_view name) {
  const std::string text = lowercase(name);
  if (const auto unit = unit_of_wkt(text)) return *unit;
  if (const auto unit = unit_of_proj(text)) return *unit;
  if (has_any(text, {"crs84", "crs83", "crs27"})) return CoordinateUnit::kDegrees;
  const bool number = !text.empty() && std::ranges::all_of(text, is_digit);
  for (const std::string_view authority : {"epsg", "esri"})
    if (const std::size_t at = text.find(authority); at != std::string::npos || number)
      if (const auto code = code_in(std::string_view(text).substr(number ? 0 : at))) return unit_of_code(*code);
  return unit_of_name(text);
}

double web_mercator_latitude(double y) { return std::atan(std::sinh(y / kEquatorRadius)) * 180.0 / kPi; }
double web_mercator_longitude(double x) { return x / kEquatorRadius * 180.0 / kPi; }
double mercator_scale(double y) { return std::cosh(y / kEquatorRadius); }

}  // namespace arcway::internal::detail

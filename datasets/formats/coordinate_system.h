#pragma once

#include <string>
#include <string_view>

namespace arcway::internal::detail {

/// What the numbers of a named coordinate reference system are.
enum class CoordinateUnit {
  kMeters,       ///< meters of a projection that keeps lengths to about a thousandth, or of a local frame
  kDegrees,      ///< longitude and latitude
  kGrads,        ///< longitude and latitude, 400 grads a turn
  kWebMercator,  ///< Mercator's projection of a sphere, 1 unit a meter at the equator
  kMercator,     ///< Mercator's projection of an ellipsoid, 1 unit a meter at the equator
  kStretched,    ///< another projection of the globe that does not keep lengths
  kOtherUnit,    ///< a plane in feet, yards, chains, links or kilometers
  kGeocentric,   ///< meters in space, along axes through the middle of the globe
  kUnknown       ///< a name that is not known
};

/// Tells what a name means: an EPSG, ESRI or OGC code in any notation ("EPSG:4269", "urn:ogc:def:crs:EPSG::4269",
/// "http://www.opengis.net/def/crs/EPSG/0/4269", "4269", "CRS84"), WKT ("GEOGCRS[...]"), a PROJ string
/// ("+proj=longlat") or a common name ("NAD83", "WGS 84 / UTM zone 32N", "local").
CoordinateUnit coordinate_unit(std::string_view name);

/// The scale of Mercator's projection on the ellipsoid or the sphere: units a meter on the ground.
/// @param y  northing.
double mercator_scale(double y);
/// Latitude of a northing of Web Mercator [degrees].
double web_mercator_latitude(double y);
/// Longitude of an easting of Web Mercator [degrees].
double web_mercator_longitude(double x);

}  // namespace arcway::internal::detail

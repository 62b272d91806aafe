#pragma once

namespace arcway {

/// How files of polygons with coordinates are read.
struct VectorOptions {
  /// Coordinates are longitude and latitude in degrees, or Web Mercator if the file says so. Projects them to meters on
  /// the ground, x east and y north of the middle of the map, by the azimuthal equidistant projection of WGS 84.
  /// Lengths are right to 1 mm a kilometer within 15.5 km of the middle. A note says how exact they are, or a warning
  /// where they are less so. Maps may lie across the antimeridian or around a pole.
  bool lonlat = false;
  /// Coordinates are meters, whatever the file says of them or they look like.
  bool planar = false;
  /// Polygons without a role of their own are free space, and all around them is blocked: their union is what is free.
  /// Several that touch or overlap are united by GEOS if it was found when building; otherwise they must be disjoint.
  bool free_polygons = false;
  /// Above 0, line strings are walls of this width with square ends [m]; otherwise they are passed over with a warning.
  double wall_width = 0.0;
  /// Smooth outlines become rings that contain the obstacle, nowhere farther from it than this [m], > 0. At most a
  /// million vertices of a map may come of that.
  double curve_tolerance = 0.01;
  /// Rings keep repeated positions, and may have fewer than three: for the doctor, as World refuses them.
  bool as_written = false;
};

}  // namespace arcway

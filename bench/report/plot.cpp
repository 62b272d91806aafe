#include "bench/report/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/report/markup.h"

namespace arcway::internal::report {
namespace {

// Okabe and Ito's colors, told apart with any color vision and on light and dark ground.
constexpr std::array<const char*, 6> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array<const char*, 4> kDashes = {"", "7 3", "2 3", "9 3 2 3"};
constexpr double kWidth = 600.0, kHeight = 400.0, kLeft = 86.0, kRight = 16.0, kTop = 14.0, kBottom = 56.0,
                 kLabelWidth = 24.0;

struct Axis {
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  double start = 0.0, end = 1.0;  // in the picture

  [[nodiscard]] double at(double value) const {
    const double share = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return start + share * (end - start);
  }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> ticks;
    if (logarithmic) {
      for (double t = std::pow(10.0, std::ceil(std::log10(low) - 1e-9)); t <= high * 1.0001; t *= 10.0)
        ticks.push_back(t);
      const std::size_t step = ticks.size() / 7 + 1;
      std::vector<double> few;
      for (std::size_t i = 0; i < ticks.size(); i += step) few.push_back(ticks[i]);
      if (few.size() >= 2) return few;
      ticks.clear();
      for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0})
        for (double t = factor * std::pow(10.0, std::floor(std::log10(low))); t <= high * 1.0001; t *= 10.0)
          if (t >= low * 0.9999) ticks.push_back(t);
      std::ranges::sort(ticks);
      return ticks;
    }
    const double raw = (high - low) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10.0 * power;
    for (const double factor : {1.0, 2.0, 5.0})
      if (factor * power >= raw) {
        step = factor * power;
        break;
      }
    for (double t = std::ceil(low / step) * step; t <= high * 1.0001; t += step) ticks.push_back(t);
    return ticks;
  }
};

std::string marker(std::size_t shape, double x, double y, const std::string& attributes) {
  char text[256];
  switch (shape % 4) {
    case 0:
      std::snprintf(text, sizeof text, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" ", x, y);
      break;
    case 1:
      std::snprintf(text, sizeof text, "<rect x=\"%.1f\" y=\"%.1f\" width=\"8.4\" height=\"8.4\" ", x - 4.2, y - 4.2);
      break;
    case 2:
      std::snprintf(text, sizeof text, "<path d=\"M%.1f %.1fl5.4 9.4h-10.8z\" ", x, y - 5.6);
      break;
    default:
      std::snprintf(text, sizeof text, "<path d=\"M%.1f %.1fl5.6 5.6-5.6 5.6-5.6-5.6z\" ", x, y - 5.6);
  }
  return text + attributes + "/>";
}

std::string axes_svg(const PlotAxes& axes, const Axis& x, const Axis& y) {
  std::string svg = "<g class=\"axes\">";
  char text[256];
  for (const double t : x.ticks()) {
    std::snprintf(text, sizeof text, "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", x.at(t),
                  x.at(t), y.start, y.end);
    svg += text;
    std::snprintf(text, sizeof text, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", x.at(t), y.start + 20.0);
    svg += text + (t == 0.0 ? std::string("0") : axes.x_text(t)) + "</text>";
  }
  for (const double t : y.ticks()) {
    std::snprintf(text, sizeof text, "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", x.start,
                  x.end, y.at(t), y.at(t));
    svg += text;
    std::snprintf(text, sizeof text, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">", x.start - 8.0, y.at(t) + 5.0);
    svg += text + (t == 0.0 ? std::string("0") : axes.y_text(t)) + "</text>";
  }
  std::snprintf(text, sizeof text, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", 0.5 * (x.start + x.end),
                kHeight - 8.0);
  svg += text + escaped(axes.x_label) + "</text>";
  if (!axes.y_label.empty()) {
    std::snprintf(text, sizeof text, "<text transform=\"translate(21 %.1f) rotate(-90)\" text-anchor=\"middle\">",
                  0.5 * (y.start + y.end));
    svg += text + escaped(axes.y_label) + "</text>";
  }
  if (axes.level) {
    std::snprintf(text, sizeof text, "<line class=\"level\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", x.start,
                  x.end, y.at(*axes.level), y.at(*axes.level));
    svg += text;
  }
  return svg + "</g>";
}

std::string curve_svg(const PlotAxes& axes, const Curve& curve, std::size_t index, const Axis& x, const Axis& y) {
  const std::string color = kColors[index % kColors.size()];
  std::string line, bars, markers;
  char text[256];
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Curve::Point& p = curve.points[i];
    std::snprintf(text, sizeof text, "%s%.1f %.1f", i == 0 ? "M" : "L", x.at(p.x), y.at(p.y));
    line += text;
    std::snprintf(text, sizeof text, "M%.1f %.1fV%.1f", x.at(p.x), y.at(p.low), y.at(p.high));
    bars += text;
    const std::string look =
        p.noise.empty() ? "fill=\"" + color + "\"" : "class=\"noisy\" stroke=\"" + color + "\" stroke-width=\"2\"";
    const std::string tip = curve.name + ": " + axes.x_text(p.x) + " → " + axes.y_text(p.y) + " (" +
                            axes.y_text(p.low) + " to " + axes.y_text(p.high) + ")" +
                            (p.noise.empty() ? "" : "; noisy: " + p.noise);
    markers += marker(index, x.at(p.x), y.at(p.y), look + " tabindex=\"0\" data-tip=\"" + escaped(tip) + "\"");
  }
  const std::string stroke = "\" fill=\"none\" stroke=\"" + color + "\" ";
  std::string svg = "<g><path d=\"" + line + stroke + "stroke-width=\"2\" stroke-dasharray=\"" +
                    kDashes[index % kDashes.size()] + "\"/><path d=\"" + bars + stroke + "stroke-width=\"1.5\"/>";
  if (const std::vector<SizePoint> points = fitted_points(curve); curve.fit && points.size() > 1) {
    std::string fitted;
    const double low = points.front().size, high = points.back().size;
    for (int i = 0; i <= 24; ++i) {
      const double size = x.logarithmic ? low * std::pow(high / low, i / 24.0) : low + (high - low) * i / 24.0;
      const double seconds = curve.fit->factor * std::pow(size, curve.fit->exponent);
      std::snprintf(text, sizeof text, "%s%.1f %.1f", i == 0 ? "M" : "L", x.at(size), y.at(seconds));
      fitted += text;
    }
    svg += "<path class=\"fit\" d=\"" + fitted + stroke + "stroke-width=\"5\" stroke-opacity=\"0.25\"/>";
  }
  return svg + markers + "</g>";
}

}  // namespace

std::vector<SizePoint> fitted_points(const Curve& curve) {
  std::vector<SizePoint> points;
  for (const Curve::Point& p : curve.points)
    if (p.noise.empty()) points.push_back({p.x, p.y});
  return points;
}

std::string time_text(double seconds) {
  constexpr double kRoundsUp = 0.9995;  // to 1 with three digits
  if (seconds >= 100.0) return number_text("%.0f s", seconds);
  if (seconds >= kRoundsUp) return number_text("%.3g s", seconds);
  if (seconds >= 1e-3 * kRoundsUp) return number_text("%.3g ms", 1e3 * seconds);
  if (seconds >= 1e-6 * kRoundsUp) return number_text("%.3g µs", 1e6 * seconds);
  return number_text("%.3g ns", 1e9 * seconds);
}

std::string size_text(double size) {
  if (size >= 1e6) return number_text("%.3gM", size / 1e6);
  if (size >= 1e4) return number_text("%.3gk", size / 1e3);
  return number_text("%.4g", size);
}

std::string ratio_text(double ratio) { return number_text(ratio >= 100.0 ? "%.0f" : "%.3g", ratio); }

std::string plot_svg(const PlotAxes& axes, std::span<const Curve> all_curves) {
  std::vector<Curve> curves(all_curves.begin(), all_curves.end());
  // A logarithmic axis has no place for the others.
  for (Curve& curve : curves) std::erase_if(curve.points, [](const Curve::Point& p) { return !(p.low > 0.0); });
  Axis xs, ys;
  xs.low = ys.low = INFINITY;
  xs.high = ys.high = 0.0;
  for (const Curve& curve : curves)
    for (const Curve::Point& p : curve.points) {
      xs.low = std::min(xs.low, p.x);
      xs.high = std::max(xs.high, p.x);
      ys.low = std::min(ys.low, p.low);
      ys.high = std::max(ys.high, p.high);
    }
  if (!(xs.high > 0.0)) xs.low = ys.low = 1.0, xs.high = ys.high = 10.0;  // empty
  if (axes.level) ys.low = std::min(ys.low, *axes.level), ys.high = std::max(ys.high, *axes.level);
  std::string svg =
      "<svg class=\"plot\" viewBox=\"0 0 600 400\" role=\"img\" aria-label=\"" + escaped(axes.title) + "\">";
  for (const bool logarithmic : {true, false}) {
    Axis x = xs, y = ys;
    x.logarithmic = y.logarithmic = logarithmic;
    x.start = kLeft + (axes.y_label.empty() ? 0.0 : kLabelWidth), x.end = kWidth - kRight;
    y.start = kHeight - kBottom, y.end = kTop;
    if (logarithmic) {
      const double x_room = std::pow(x.high / x.low, 0.04), y_room = std::pow(y.high / y.low, 0.05) * 1.02;
      x.low /= x_room, x.high *= x_room;
      y.low /= y_room, y.high *= y_room;
    } else {
      x.low = y.low = 0.0;
      x.high *= 1.04, y.high *= 1.05;
    }
    svg += logarithmic ? "<g class=\"log\">" : "<g class=\"linear\">";
    svg += axes_svg(axes, x, y);
    for (std::size_t i = 0; i < curves.size(); ++i) svg += curve_svg(axes, curves[i], i, x, y);
    svg += "</g>";
  }
  return svg + "</svg>";
}

std::string legend_key(std::size_t index) {
  const std::string color = kColors[index % kColors.size()];
  return "<svg class=\"key\" viewBox=\"0 0 36 14\"><path d=\"M0 7H36\" stroke=\"" + color +
         "\" stroke-width=\"2\" stroke-dasharray=\"" + kDashes[index % kDashes.size()] + "\"/>" +
         marker(index, 18.0, 7.0, "fill=\"" + color + "\"") + "</svg>";
}

}  // namespace arcway::internal::report

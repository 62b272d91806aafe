#include "bench/report/markup.h"

#include <algorithm>
#include <cstdio>

#include "bench/report/study.h"

namespace arcway::internal::report {

std::string number_text(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string with_superscripts(std::string_view escaped) {
  std::string text;
  for (std::size_t i = 0; i < escaped.size();) {
    const std::size_t end = escaped[i] == '^' ? escaped.find_first_not_of("-.0123456789", i + 1) : i + 1;
    const std::size_t length = std::min(end, escaped.size()) - i;
    text +=
        length == 1 ? std::string(1, escaped[i]) : "<sup>" + std::string(escaped.substr(i + 1, length - 1)) + "</sup>";
    i += length;
  }
  return text;
}

std::string listed(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

std::string count_text(double value) {
  std::string digits = number_text("%.0f", value);
  for (std::size_t end = digits.size(); end > 3; end -= 3) {
    if (digits[end - 4] != '-') digits.insert(end - 3, ",");
  }
  return digits;
}

std::string figure_html(const PlotAxes& axes, std::span<const Curve> curves, std::string_view caption) {
  std::string legend = "<ul class=\"legend\">";
  for (std::size_t i = 0; i < curves.size(); ++i)
    legend += "<li>" + legend_key(i) + " " + escaped(curves[i].name) +
              (curves[i].fit ? ": " + with_superscripts(power_text("n", curves[i].fit)) : "") + "</li>";
  const bool has_fit = std::ranges::any_of(curves, [](const Curve& curve) { return curve.fit.has_value(); });
  const bool has_noise = std::ranges::any_of(curves, [](const Curve& curve) {
    return !std::ranges::all_of(curve.points, &std::string::empty, &Curve::Point::noise);
  });
  if (has_noise) legend += "<li>hollow: noisy, left out of fits</li>";
  return "<figure>" + plot_svg(axes, curves) + legend + "</ul><figcaption>" + escaped(caption) +
         (has_fit ? " Pale bands: fitted powers of n, what is along the axis, with the exponents' 95 % intervals."
                  : "") +
         "</figcaption></figure>";
}

}  // namespace arcway::internal::report

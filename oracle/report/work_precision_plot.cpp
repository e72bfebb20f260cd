#include <groundtruth/report/work_precision_plot.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <groundtruth/report/chart.hpp>
#include <groundtruth/report/html.hpp>

namespace groundtruth::report {
namespace {

using precision::TierResult;

constexpr double panel_width = 455, inner_left = 62, inner_width = 372, top = 50, wrong_height = 118,
                 right_height = 150, gap = 12, bottom = 46;
constexpr double height = top + wrong_height + gap + right_height + bottom;
constexpr double least_share = 1e-4;

Hue hue_of(const std::string& tier) {
  if (tier == "fast") return Hue::ours;
  if (tier == "exact" || tier == "definition") return Hue::engines;
  if (tier == "cpp_bin_float_50" || tier.starts_with("mpfr")) return Hue::software;
  return tier == "cgal-lazy" || tier == "interval" ? Hue::lazy : Hue::machine;
}

bool is_shown(const TierResult& result) { return result.omitted.empty(); }

// Both panels of a figure share their scales.
struct Scales {
  int first_ns = 1, last_ns = 2;  // powers of ten
  int first_ulp = -2, last_ulp = 1;

  explicit Scales(const std::vector<const Study*>& studies) {
    double least = 1e300, most = 0, worst = 10;
    for (const Study* study : studies)
      for (const TierResult& result : study->results) {
        if (!is_shown(result)) continue;
        least = std::min(least, result.nanoseconds.median);
        most = std::max(most, result.nanoseconds.median);
        if (result.share_unanswered() == 0) worst = std::max(worst, std::min(result.worst_ulps, 1e20));
      }
    first_ns = static_cast<int>(std::floor(std::log10(std::max(least, 1.0))));
    last_ns = std::max(first_ns + 1, static_cast<int>(std::ceil(std::log10(std::max(most, 1.0)))));
    last_ulp = static_cast<int>(std::ceil(std::log10(worst)));
  }
};

class Panel {
 public:
  Panel(Chart& chart, const Scales& scales, double left) : chart_(chart), scales_(scales), left_(left) {}

  void draw(const Study& study) {
    draw_axes(study);
    std::vector<const TierResult*> shown;
    for (const TierResult& result : study.results)
      if (is_shown(result)) shown.push_back(&result);
    std::sort(shown.begin(), shown.end(), [](const TierResult* a, const TierResult* b) {
      return a->nanoseconds.median < b->nanoseconds.median;
    });
    std::vector<Place> front;
    for (const TierResult* result : shown)
      if (result->is_on_front) front.push_back(place_of(*result));
    chart_.line(front, "front");
    for (const TierResult* result : shown)
      chart_.mark(mark_of(*result), hue_of(result->tier), place_of(*result));
    for (const TierResult* result : shown)
      chart_.label(place_of(*result), hue_of(result->tier), result->tier);
  }

 private:
  static Mark mark_of(const TierResult& result) {
    if (result.wrong > 0) return Mark::cross;
    return result.undecided > 0 ? Mark::ring : Mark::disc;
  }

  double x_of(double ns) const {
    const double share =
        (std::log10(std::max(ns, 1e-3)) - scales_.first_ns) / (scales_.last_ns - scales_.first_ns);
    return left_ + inner_left + inner_width * share;
  }
  static double y_of_share(double share) {
    const double up = std::log10(std::max(share, least_share) / least_share) / -std::log10(least_share);
    return top + wrong_height * (1 - up);
  }
  double y_of_ulps(double ulps) const {
    const double up = (std::log10(std::clamp(ulps, 0.01, 1e20)) - scales_.first_ulp) /
                      (scales_.last_ulp - scales_.first_ulp);
    return top + wrong_height + gap + right_height * (1 - up);
  }
  Place place_of(const TierResult& result) const {
    const double share = result.share_unanswered();
    return {x_of(result.nanoseconds.median), share > 0 ? y_of_share(share) : y_of_ulps(result.worst_ulps)};
  }

  void draw_axes(const Study& study) {
    const double left = left_ + inner_left, right = left + inner_width, base = height - bottom;
    for (int power = scales_.first_ns; power <= scales_.last_ns; ++power) {
      const double x = x_of(std::pow(10, power));
      chart_.grid({x, top}, {x, base});
      chart_.text({x, base + 16}, "middle", duration_in_words(std::pow(10, power)), "small");
    }
    for (const double share : {1.0, 0.1, 0.01, 0.001}) {
      const double y = y_of_share(share);
      chart_.grid({left, y}, {right, y});
      chart_.text({left - 6, y + 4}, "end", fmt::format("{:g} %", 100 * share), "small");
    }
    const int apart = std::max(1, (scales_.last_ulp - scales_.first_ulp + 3) / 6);
    for (int power = scales_.last_ulp; power >= scales_.first_ulp; power -= apart) {
      const double y = y_of_ulps(std::pow(10, power));
      chart_.grid({left, y}, {right, y});
      chart_.text({left - 6, y + 4}, "end", power_of_ten(power), "small");
    }
    chart_.frame(left, top, inner_width, wrong_height);
    chart_.frame(left, top + wrong_height + gap, inner_width, right_height);
    chart_.occupy(left, top + wrong_height, inner_width, gap);
    chart_.occupy(left_, base, inner_left + inner_width, bottom);
    chart_.occupy(left_, top - 22, inner_left + inner_width, 20);
    chart_.turned_text({left_ + 12, top + wrong_height / 2}, "share not right");
    chart_.turned_text({left_ + 12, top + wrong_height + gap + right_height / 2}, "worst error, ulp");
    chart_.text({left + inner_width / 2, base + 34}, "middle", "time per ask", "small");
    chart_.text({left, top - 10}, "start",
                fmt::format("{} asks ({})", precision::name_of(study.population), study.asks), "head");
  }

  Chart& chart_;
  const Scales& scales_;
  double left_;
};

std::string description_of(const std::vector<const Study*>& studies) {
  std::string words;
  for (const Study* study : studies) {
    words += fmt::format("{} asks: ", precision::name_of(study->population));
    for (const TierResult& result : study->results) {
      if (!is_shown(result)) continue;
      words += fmt::format("{} {} wrong, {} undecided, worst {} ulp, {}; ", result.tier, result.wrong,
                           result.undecided, short_number(result.worst_ulps),
                           duration_in_words(result.nanoseconds.median));
    }
  }
  return words;
}

}  // namespace

std::string work_precision_plot(const std::string& title, const std::vector<const Study*>& studies) {
  Chart chart(panel_width * static_cast<double>(studies.size()) + 10, height, title, description_of(studies));
  const Scales scales(studies);
  chart.text({inner_left, 20}, "start", title, "head");
  double left = 0;
  for (const Study* study : studies) {
    Panel(chart, scales, left).draw(*study);
    left += panel_width;
  }
  return chart.finished();
}

}  // namespace groundtruth::report

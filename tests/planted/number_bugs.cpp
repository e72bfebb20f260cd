// Mistakes of arithmetic.

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <fmt/core.h>

#include "ways.hpp"

namespace groundtruth::planted {
namespace {

float single(double value) { return static_cast<float>(value); }

double lambda_in_float(double lambda, const EntryAsk&) {
  return std::abs(lambda) < 1e38 ? single(lambda) : lambda;
}

double with_15_digits(double lambda, const EntryAsk&) {
  return std::strtod(fmt::format("{:.15g}", lambda).c_str(), nullptr);
}

double interpolated(double lambda, const EntryAsk& ask) {
  const double length = ask.lambda_last - ask.lambda_first;
  if (!(length > 0) || std::isinf(length)) return lambda;
  return ask.lambda_first + (lambda - ask.lambda_first) / length * length;
}

double tiny_is_zero(double lambda, const EntryAsk&) { return std::abs(lambda) < 1e-9 ? 0 : lambda; }

double nearly_one_is_one(double lambda, const EntryAsk&) { return std::abs(lambda - 1) < 1e-12 ? 1 : lambda; }

// The right face, lambda from its distances at both ends in doubles.
EntryAnswer lambda_in_doubles(const Meeting& meeting) {
  if (meeting.at_start) return meeting.border;
  const HalfSpace& plane = meeting.half_space(meeting.border.leaf);
  const auto distance = [&](const Vector& x) {
    const Vector& n = plane.normal;
    return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - plane.offset;
  };
  const double near = distance(meeting.ask.from);
  const double lambda = near / (near - distance(meeting.ask.to));
  if (!std::isfinite(lambda)) return meeting.border;
  Border border = meeting.border;
  border.lambda = lambda;
  return border;
}

EntryAnswer normal_in_float(const Meeting& meeting) {
  Border border = meeting.border;
  for (double& component : border.normal_in_world) component = single(component);
  return border;
}

template <class Change>
EntryAsk with_coordinates(EntryAsk ask, Change change) {
  for (Vector* end : {&ask.from, &ask.to}) {
    for (double& coordinate : *end) coordinate = change(coordinate);
  }
  return ask;
}

EntryAsk far_is_float(EntryAsk ask) {
  return with_coordinates(ask,
                          [](double x) { return std::abs(x) > 1e6 && std::abs(x) < 1e38 ? single(x) : x; });
}

EntryAsk on_micrometres(EntryAsk ask) {
  return with_coordinates(ask, [](double x) { return std::abs(x) < 1e9 ? std::round(x * 1e6) / 1e6 : x; });
}

EntryAsk without_subnormals(EntryAsk ask) {
  return with_coordinates(
      ask, [](double x) { return std::abs(x) < std::numeric_limits<double>::min() ? 0.0 : x; });
}

EntryAsk no_farther_than_a_float(EntryAsk ask) {
  return with_coordinates(ask, [](double x) { return std::abs(x) > 3e38 ? std::copysign(3e38, x) : x; });
}

}  // namespace

std::vector<Bug> number_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"lambda-in-float", entry, common, "lambda is rounded to float", on_lambdas(lambda_in_float)},
      {"lambda-with-15-digits", entry, common, "lambda is printed with 15 digits",
       on_lambdas(with_15_digits)},
      {"lambda-interpolated", entry, special, "lambda goes through a fraction of the range and back",
       on_lambdas(interpolated)},
      {"tiny-lambda-is-zero", entry, extreme, "lambda below 1e-9 in size is cleaned to 0",
       on_lambdas(tiny_is_zero)},
      {"lambda-snaps-to-one", entry, extreme, "lambda within 1e-12 of 1 is 1", on_lambdas(nearly_one_is_one)},
      {"lambda-in-doubles", entry, special, "the right face, but lambda computed in doubles",
       on_borders(lambda_in_doubles)},
      {"normal-in-float", entry, special, "the normal is answered in float", on_borders(normal_in_float)},
      {"far-is-float", entry, special, "coordinates beyond 1,000 km are kept in float",
       understands(far_is_float)},
      {"micrometre-grid", entry, special, "coordinates are snapped to micrometres",
       understands(on_micrometres)},
      {"subnormals-are-zero", entry, extreme, "subnormal coordinates are flushed to 0",
       understands(without_subnormals)},
      {"float-range", entry, extreme, "coordinates beyond the range of floats are cut to it",
       understands(no_farther_than_a_float)},
  };
}

}  // namespace groundtruth::planted

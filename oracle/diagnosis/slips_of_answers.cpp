#include <cmath>

#include <groundtruth/diagnosis/slips.hpp>

namespace groundtruth::diagnosis {
namespace {

Border* border_in(Answer& answer) {
  auto* entry = std::get_if<EntryAnswer>(&answer);
  return entry ? std::get_if<Border>(entry) : nullptr;
}

Stepped* stepped_in(Answer& answer) {
  auto* step = std::get_if<StepAnswer>(&answer);
  return step ? std::get_if<Stepped>(step) : nullptr;
}

template <class Change>
void in_vectors(Answer& answer, Change change) {
  if (auto* clip = std::get_if<ClipAnswer>(&answer))
    if (auto* clipped = std::get_if<Clipped>(clip)) change(clipped->force_in_wheel);
  Stepped* stepped = stepped_in(answer);
  if (stepped == nullptr) return;
  change(stepped->force_on_frame_in_world);
  auto* contact = std::get_if<Contact>(&stepped->state);
  if (contact == nullptr) return;
  change(contact->pebble_in_world);
  change(contact->pebble_velocity_in_world);
}

double* lambda_in(Answer& answer) {
  if (Border* border = border_in(answer)) return &border->lambda;
  auto* entry = std::get_if<EntryAnswer>(&answer);
  auto* inside = entry ? std::get_if<Inside>(entry) : nullptr;
  return inside ? &inside->lambda : nullptr;
}

void round_to_float(Answer& answer, const Ask&) {
  const auto round = [](double& number) { number = static_cast<float>(number); };
  if (double* lambda = lambda_in(answer)) round(*lambda);
  in_vectors(answer, [&](Vector& vector) {
    for (double& number : vector) round(number);
  });
}

void measure_lambda_from_range(Answer& answer, const Ask& ask) {
  const auto* entry = std::get_if<EntryAsk>(&ask);
  double* lambda = lambda_in(answer);
  if (entry == nullptr || lambda == nullptr || entry->lambda_first == entry->lambda_last) return;
  *lambda = (*lambda - entry->lambda_first) / (entry->lambda_last - entry->lambda_first);
}

void turn_force_into_wheel(Answer& answer, const Ask& ask) {
  Stepped* stepped = stepped_in(answer);
  const auto* step = std::get_if<StepAsk>(&ask);
  if (stepped == nullptr || step == nullptr) return;
  // v -> q^-1 v q, in doubles.
  const auto& [w, x, y, z] = step->frame.world_from_wheel;
  const double n = w * w + x * x + y * y + z * z;
  const Vector f = stepped->force_on_frame_in_world;
  const Vector u{-x, -y, -z};
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const double dot = u[0] * f[0] + u[1] * f[1] + u[2] * f[2];
  const Vector across = cross(u, f);
  for (std::size_t i = 0; i < 3; ++i)
    stepped->force_on_frame_in_world[i] =
        ((w * w - (x * x + y * y + z * z)) * f[i] + 2 * dot * u[i] + 2 * w * across[i]) / n;
}

void normalise(Answer& answer, const Ask&) {
  Border* border = border_in(answer);
  if (border == nullptr) return;
  auto& n = border->normal_in_world;
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x /= length;
}

void multiply_velocity_by_h(Answer& answer, const Ask& ask) {
  Stepped* stepped = stepped_in(answer);
  if (stepped == nullptr) return;
  auto* contact = std::get_if<Contact>(&stepped->state);
  if (contact == nullptr) return;
  for (double& x : contact->pebble_velocity_in_world) x *= std::get<StepAsk>(ask).h;
}

// At the range's first end, where the point is interior.
void call_inside_border(Answer& answer, const Ask&) {
  auto* entry = std::get_if<EntryAnswer>(&answer);
  auto* inside = entry ? std::get_if<Inside>(entry) : nullptr;
  if (inside) *entry = Border{inside->lambda, 0, {}, std::nullopt};
}

void call_start_on_face_inside(Answer& answer, const Ask& ask) {
  Border* border = border_in(answer);
  const auto* entry = std::get_if<EntryAsk>(&ask);
  if (border && entry && border->lambda == entry->lambda_first) answer = EntryAnswer{Inside{border->lambda}};
}

constexpr AnswerSlip slips[] = {
    {"float-results", "results are rounded to 32-bit floats", round_to_float},
    {"lambda-from-range", "lambda is measured in the range, not along the segment",
     measure_lambda_from_range},
    {"force-in-wheel-frame", "the force is given in wheel coordinates, not in the world's",
     turn_force_into_wheel},
    {"normal-negated", "normals point inwards",
     [](Answer& answer, const Ask&) {
       if (Border* border = border_in(answer))
         for (double& x : border->normal_in_world) x = 0 - x;
     }},
    {"normal-normalised", "normals are given at unit length", normalise},
    {"h-forgotten", "the pebble's velocity is its displacement", multiply_velocity_by_h},
    {"inside-as-border", "a start inside the solid is reported as a border", call_inside_border},
    {"start-on-face-as-inside", "a start on a face is reported as inside", call_start_on_face_inside},
    {"material-missing", "no material is found",
     [](Answer& answer, const Ask&) {
       if (Border* border = border_in(answer)) border->material.reset();
     }},
};

}  // namespace

std::span<const AnswerSlip> answer_slips() { return slips; }

}  // namespace groundtruth::diagnosis

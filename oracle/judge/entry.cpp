#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "direction.hpp"
#include "weigh.hpp"
#include "wording.hpp"

namespace groundtruth::judge {
namespace {

bool is_miss(const EntryAnswer& answer) { return std::holds_alternative<Miss>(answer); }
bool is_inside(const EntryAnswer& answer) { return std::holds_alternative<Inside>(answer); }

double lambda_of(const EntryAnswer& hit) {
  const auto* border = std::get_if<Border>(&hit);
  return border ? border->lambda : std::get<Inside>(hit).lambda;
}

std::string told(const Answered& exact) {
  const auto& entry = std::get<EntryAnswer>(exact.answer);
  if (is_miss(entry)) return "miss";
  if (is_inside(entry)) return fmt::format("inside at {}", words_of_lambda(exact));
  return fmt::format("border at {} on {}", words_of_lambda(exact),
                     words_of_leaves(exact.evidence.admissible));
}

double capped(const Rational& value) {
  constexpr double most = std::numeric_limits<double>::max();
  return value > rational(most) ? most : value.convert_to<double>();
}

Verdict wrong(Difference difference, std::string explanation) {
  Verdict verdict;
  verdict.difference = difference;
  verdict.explanation = std::move(explanation);
  return verdict;
}

class EntryWeighing {
 public:
  EntryWeighing(const Truth& truth, const EntryAsk& ask, const EntryAnswer& got, const Answered& exact)
      : truth_(truth),
        tolerance_(truth.tolerance()),
        ask_(ask),
        got_(got),
        exact_(exact),
        exact_entry_(std::get<EntryAnswer>(exact.answer)),
        way_(minus(rational(ask.to), rational(ask.from))) {}

  Verdict weigh() const {
    const Verdict against_exact = weigh_against_exact();
    if (against_exact.is_accepted() || tolerance_.metres == 0) return against_exact;
    return weigh_between_shapes();
  }

 private:
  Verdict weigh_against_exact() const {
    if (is_miss(got_) && is_miss(exact_entry_)) return {};
    if (is_miss(got_) || is_miss(exact_entry_)) return hit_against_miss();
    const Rational lambda = rational(lambda_of(got_));
    if (!lies_in_range()) return out_of_range();
    if (!is_near(lambda, exact_)) return far_from_exact();
    if (is_inside(got_) != is_inside(exact_entry_)) return wrong_kind();
    if (is_inside(got_)) return {};
    const Border& border = std::get<Border>(got_);
    const std::vector<Leaf>& admissible = exact_.evidence.admissible;
    const bool named = std::find(admissible.begin(), admissible.end(), border.leaf) != admissible.end();
    const Leaf canonical = std::get<Border>(exact_entry_).leaf;
    const bool may_be_named = tolerance_.faces == Faces::canonical ? border.leaf == canonical : named;
    if (!may_be_named) return wrong_leaf();
    if (border.leaf == canonical) return weigh_face({std::get<Border>(exact_entry_).material});
    const Around point{along(rational(ask_.from), exact_lambda(exact_), way_), 0};
    return weigh_face(materials_of(truth_.scene().shape, border.leaf, point));
  }

  // SPEC section 6: some shape between S-tau and S+tau explains the answer (proofs-notes/tolerance.md, 1).
  Verdict weigh_between_shapes() const {
    const Answered grown = truth_.answer_on_grown(ask_);
    const Answered shrunk = truth_.answer_on_shrunk(ask_);
    const auto& on_grown = std::get<EntryAnswer>(grown.answer);
    const auto& on_shrunk = std::get<EntryAnswer>(shrunk.answer);
    if (is_miss(got_)) return is_miss(on_shrunk) ? Verdict{} : hit_against_miss();
    if (is_miss(on_grown)) return hit_against_miss();
    if (!lies_in_range()) return out_of_range();
    const Rational lambda = rational(lambda_of(got_));
    const bool early = lambda < exact_lambda(grown) && !is_near(lambda, grown);
    const bool late = !is_miss(on_shrunk) && lambda > exact_lambda(shrunk) && !is_near(lambda, shrunk);
    if (early || late) return outside_of_bounds(grown, shrunk);
    if (is_inside(got_)) {
      const bool at_start = rational(ask_.lambda_first) == exact_lambda(grown) && is_near(lambda, grown);
      return at_start && is_inside(on_grown) ? Verdict{} : wrong_kind();
    }
    if (is_inside(on_shrunk)) return wrong_kind();
    if (!is_near(lambda, grown) && !touches_grown_shape()) return off_the_solid();
    return weigh_face_near_point();
  }

  Verdict weigh_face_near_point() const {
    const Border& border = std::get<Border>(got_);
    const auto* canonical = std::get_if<Border>(&exact_entry_);
    const bool strict = tolerance_.faces == Faces::canonical && canonical != nullptr;
    if (strict ? border.leaf != canonical->leaf : !is_leaf_near_point(border.leaf)) return wrong_leaf();
    const double length = std::sqrt(capped(dot(way_, way_)));
    const Around around{
        along(rational(ask_.from), rational(border.lambda), way_),
        std::min(tolerance_.metres + allowance() * length, std::numeric_limits<double>::max())};
    return weigh_face(materials_of(truth_.scene().shape, border.leaf, around));
  }

  Verdict weigh_face(const std::set<MaterialOrNone>& materials) const {
    const Border& border = std::get<Border>(got_);
    const Vector& normal = truth_.leaves()[border.leaf].normal;
    if (!points_along(border.normal_in_world, normal, tolerance_.normal_angle)) {
      return wrong(Difference::face,
                   fmt::format("normal {} -> {} of leaf {}: {} degrees off", words(border.normal_in_world),
                               words(normal), border.leaf,
                               short_number(degrees_between(border.normal_in_world, normal))));
    }
    if (materials.count(border.material) == 0) {
      return wrong(Difference::material,
                   fmt::format("material {} -> {} of leaf {}", words(border.material, truth_.scene()),
                               words(*materials.begin(), truth_.scene()), border.leaf));
    }
    return {};
  }

  static Rational exact_lambda(const Answered& exact) { return read_fraction(exact.evidence.lambda_exact); }

  bool is_near(const Rational& lambda, const Answered& exact) const {
    const Rational expected = exact_lambda(exact);
    const Rational apart = abs(lambda - expected);
    return apart <= rational(tolerance_.lambda_ulps) * unit_in_last_place(expected);
  }

  bool lies_in_range() const {
    return lambda_of(got_) >= ask_.lambda_first && lambda_of(got_) <= ask_.lambda_last;
  }

  // How far from the answer's lambda that of the shape which explains it may lie: its ulp is at most twice.
  double allowance() const {
    return 2 * tolerance_.lambda_ulps * unit_in_last_place(rational(lambda_of(got_))).convert_to<double>();
  }

  bool touches_grown_shape() const {
    EntryAsk nearby = ask_;
    const double infinity = std::numeric_limits<double>::infinity();
    const double lambda = lambda_of(got_);
    nearby.lambda_first = std::max(ask_.lambda_first, std::nextafter(lambda - allowance(), -infinity));
    nearby.lambda_last = std::min(ask_.lambda_last, std::nextafter(lambda + allowance(), infinity));
    return !is_miss(std::get<EntryAnswer>(truth_.answer_on_grown(nearby).answer));
  }

  // |height over the leaf's plane| <= tau ||n||, at some point within the allowance.
  bool is_leaf_near_point(Leaf leaf) const {
    if (leaf >= truth_.leaves().size()) return false;
    const HalfSpace& plane = truth_.leaves()[leaf];
    if (plane.normal == Vector{}) return false;
    const RationalVector normal = rational(plane.normal);
    const RationalVector point = along(rational(ask_.from), rational(lambda_of(got_)), way_);
    const Rational height = abs(dot(normal, point) - rational(plane.offset));
    const Rational beyond = height - rational(allowance()) * abs(dot(normal, way_));
    const Rational tau = rational(tolerance_.metres);
    return beyond <= 0 || beyond * beyond <= tau * tau * dot(normal, normal);
  }

  Verdict hit_against_miss() const {
    const std::string got = is_miss(got_) ? "miss" : fmt::format("hit at {}", words(lambda_of(got_)));
    return wrong(Difference::hit_miss, fmt::format("{} -> {}", got, told(exact_)));
  }

  Verdict wrong_kind() const {
    return wrong(Difference::face, fmt::format("{} -> {}", kind_in_words(got_), told(exact_)));
  }

  Verdict wrong_leaf() const {
    const Leaf leaf = std::get<Border>(got_).leaf;
    if (leaf >= truth_.leaves().size()) {
      return wrong(Difference::face, fmt::format("leaf {} -> {}: the solid has {} leaves", leaf, told(exact_),
                                                 truth_.leaves().size()));
    }
    return wrong(Difference::face, fmt::format("leaf {} -> {}", leaf, told(exact_)));
  }

  Verdict out_of_range() const {
    return wrong(Difference::lambda,
                 fmt::format("lambda {} -> {}: outside the range [{}, {}]", words(lambda_of(got_)),
                             told(exact_), words(ask_.lambda_first), words(ask_.lambda_last)));
  }

  Verdict off_the_solid() const {
    return wrong(Difference::lambda, fmt::format("lambda {} -> {}: no point of the solid within {} m",
                                                 words(lambda_of(got_)), told(exact_), tolerance_.metres));
  }

  // Fills in how far off the answer's lambda is from this one.
  Verdict far_from(const Rational& expected, const std::string& in_words) const {
    const Rational apart = abs(rational(lambda_of(got_)) - expected);
    Verdict verdict = wrong(Difference::lambda, "");
    verdict.lambda_ulps = capped(apart / unit_in_last_place(expected));
    verdict.metres = std::sqrt(capped(apart * apart * dot(way_, way_)));
    verdict.explanation = fmt::format("lambda {} -> {}: {} ulps, {} m", words(lambda_of(got_)), in_words,
                                      short_number(verdict.lambda_ulps), short_number(verdict.metres));
    return verdict;
  }

  Verdict far_from_exact() const { return far_from(exact_lambda(exact_), words_of_lambda(exact_)); }

  Verdict outside_of_bounds(const Answered& grown, const Answered& shrunk) const {
    const bool early = rational(lambda_of(got_)) < exact_lambda(grown);
    const Answered& nearest = early ? grown : shrunk;
    return far_from(exact_lambda(nearest),
                    fmt::format("{} at the {}", words_of_lambda(nearest), early ? "earliest" : "latest"));
  }

  const Truth& truth_;
  const Tolerance& tolerance_;
  const EntryAsk& ask_;
  const EntryAnswer& got_;
  const Answered& exact_;
  const EntryAnswer& exact_entry_;
  RationalVector way_;
};

}  // namespace

Verdict weigh_entry(const Truth& truth, const EntryAsk& ask, const EntryAnswer& got, const Answered& exact) {
  return EntryWeighing(truth, ask, got, exact).weigh();
}

}  // namespace groundtruth::judge

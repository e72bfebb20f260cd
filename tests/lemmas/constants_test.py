"""The constants that fast computes with are those of the lemmas: change one and its proof must follow."""

import pathlib
import re
import unittest
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEMMAS = ROOT / "proofs-notes" / "lemmas" / "numbers"

HEX = r"(-?0x[0-9a-fA-F.]+p[+-]?\d+)"

# Source, what stands around the constant there (spaces are any space), lemma file, definition.
CONSTANTS = [
    ("fast/number_counted.hpp", rf"pair_unit = {HEX};", "pair_sum.v", "pair_unit"),
    ("fast/number_counted.hpp", rf"b.error\(\) <= {HEX} \* divisor", "counted_roots.v", "known_to"),
    ("fast/number_counted.hpp", rf"a.error\(\) <= {HEX} \* approximate", "counted_roots.v", "known_to"),
    ("fast/number_counted.hpp", rf"pair_unit \* \(1 \+ {HEX}\)", "counted.v", "second_orders"),
    ("fast/cell.hpp", rf"{HEX} \* greatest_coordinate_", "delta_error.v", "per_size"),
    ("fast/cell.hpp", rf"{HEX} \* offset_size", "delta_error.v", "per_size"),
    ("fast/cell.hpp", rf"offset_size \+ {HEX}\)", "delta_error.v", "error_floor"),
    ("fast/cell.hpp", rf"{HEX} \* ends_.coordinate_error", "delta_error.v", "per_coordinate_error"),
    ("fast/cell.hpp", rf"ends_.coordinate_error \+ {HEX}\)", "delta_error.v", "error_per_normal_floor"),
    ("fast/cell.hpp", rf"greatest_usable_error = {HEX};", "delta_error.v", "greatest_usable_error"),
    ("fast/range_ends.hpp", rf"{HEX} \* \(std::abs\(lambda\)", "range_ends.v", "per_end"),
    ("fast/range_ends.hpp", rf"std::abs\(from\)\) \+ {HEX}\)", "range_ends.v", "floor"),
    ("fast/paint.cpp", rf"{HEX} \* \(std::abs\(x\) \+ std::abs\(y\)\)", "range_ends.v", "per_hit"),
    ("fast/paint.cpp", rf"{HEX} \* probe.ends\(\).coordinate_error", "range_ends.v", "per_coordinate_error"),
    ("fast/paint.cpp", rf"coordinate_error \+ {HEX};", "range_ends.v", "floor"),
    ("fast/crossing_body.hpp", rf"magnitude > {HEX}", "crossing_bound.v", "least_lambda"),
    ("fast/crossing_body.hpp", rf"size < {HEX}", "crossing_bound.v", "greatest_size"),
    ("fast/crossing_body.hpp", rf"{HEX} \* \(1 \+ 2 \* magnitude\) \* inverse", "crossing_bound.v", "underflow"),
    ("fast/box_probe.hpp", rf"pad = {HEX} \* \(std::abs", "box_slabs.v", "delta"),
    ("fast/surface_in_doubles.hpp", rf"margin = {HEX} \* sizes", "decisions.v", "margin_part"),
    ("fast/surface_in_doubles.hpp", rf"(?:depth_squared|down_|\(squared) > {HEX}", "decisions.v", "line_part"),
    ("fast/surface_in_pairs.hpp", rf"return {HEX} \* \(ask.force_size", "clip_in_pairs.v", "per_clip"),
    ("fast/box.cpp", rf"tiny = {HEX}", "box.v", "floor"),
    ("fast/box.cpp", rf"greatest_slack = {HEX}", "box.v", "greatest_slack"),
]

# Expressions that the lemmas are about, as they stand in the source: a changed operation needs another proof.
EXPRESSIONS = [
    ("fast/cell.hpp", "return normal_size * error_per_normal_ + (0x11p-53 * offset_size + 0x1p-960);"),
    ("fast/range_ends.hpp", "return from + lambda * (to - from);"),
    ("fast/cell_kernels_body.hpp", "x * first_x_ + y * first_y_ + z * first_z_ - offset"),
    ("fast/cell_kernels_body.hpp", "x * last_x_ + y * last_y_ + z * last_z_ - offset"),
    ("fast/cell_kernels_body.hpp", "const Lanes w = a - b, inverse = Lanes::all(1) / w;"),
    ("fast/cell_kernels_body.hpp",
     "const Lanes middle = a * inverse, error = error_ * inverse, margin = greater(error, -error);"),
    ("fast/cell_kernels_body.hpp",
     "return {greater(a, b) < -error_, w > twice_error_, w < -twice_error_, middle - margin, middle + margin};"),
    ("fast/number_pair.hpp", "const Number sum = a + b, b_part = sum - a; return {sum, (a - (sum - b_part)) + (b - b_part)};"),
    ("fast/number_pair.hpp", "const Number sum = a + b; return {sum, b - (sum - a)};"),
    ("fast/number_pair.hpp", "return {s.high, s.low + (a.low + b.low)};"),
    ("fast/number_pair.hpp", "return {p.high, p.low + (a.high * b.low + a.low * b.high)};"),
    ("fast/crossing_body.hpp", "const double error = 128 * unit * unit * (size * inverse) * (1 + 2 * magnitude) +"
                               " 32 * unit * unit * magnitude + 0x1p-1000 * (1 + 2 * magnitude) * inverse;"),
    ("fast/crossing_body.hpp", "return {s2.value, ((e0 + e1) + e2) + ((s0.lost + s1.lost) + s2.lost),"),
    ("fast/crossing_body.hpp", "Products::remainder(at.value[0], q0, w.value) + (at.rest[0] - q0 * w.lost);"),
    ("fast/crossing_body.hpp", "const auto lambda = Twice::sum(q0, remainder * signed_inverse);"),
    ("fast/crossing_body.hpp", "lambda.value + (lambda.lost + error) == lambda.value + (lambda.lost - error)"),
    ("fast/number_counted.hpp", "std::abs(static_cast<double>(a.value)) * (1 + 0x1p-50) + 2 * a.error();"),
    ("fast/number_counted.hpp", "const double inverse = 1.01 / divisor;"),
    ("fast/number_counted.hpp", "1.01 * std::max(a.size, approximate) / std::sqrt(approximate)"),
    ("fast/number_pair.hpp", "const double first = a.high / b.high; const PairWith rest = a - first * b;"
                             " return sorted_sum(first, rest.high / b.high);"),
    ("fast/number_pair.hpp", "const PairWith rest = a - product(first, first);"
                             " return sorted_sum(first, rest.high / (2 * first));"),
    ("fast/pairs.hpp", "const auto first = a.high * inverse; const Pair product = Pair::product(first, b.high);"
                       " const auto rest = ((a.high - product.high) - product.low) + (a.low - first * b.low);"
                       " return Pair::sorted_sum(first, rest * inverse);"),
    ("fast/pairs.hpp", "const double rest = ((a.high - square.high) - square.low) + a.low;"
                       " return {Pair::sorted_sum(first, rest * (0.5 * inverse)), inverse};"),
    ("fast/box_probe.hpp", "const double from = ends.first[axis], way = ends.last[axis] - from + 0.0;"),
    ("fast/box_probe.hpp", "(std::abs(from) + std::abs(way)) + 8 * ends.coordinate_error + 1e-20;"),
    ("fast/box_probe.hpp", "constexpr double shortest_way = 1e-30;"),
    ("fast/box_probe.hpp", "static_cast<float>(from + pad_along);"),
    ("fast/box_probe.hpp", "static_cast<float>(from - pad_along);"),
    ("fast/grid.hpp", "return whole((x - origin_across) * per_metre, columns - 1);"),
    ("fast/grid.hpp", "return whole((x - origin_upward) * upward_per_metre, Stretches::last_place);"),
    ("fast/grid.hpp", "return whole((place - square) * (Stretches::last_place + 1), Stretches::last_place);"),
    ("fast/grid.hpp", "if (!(place > 0)) return 0; return place < last ? static_cast<std::uint32_t>(place) : last;"),
    ("fast/grid.hpp", "last_place = 511;"),
    ("fast/grid.hpp", "free_bits = 0x0802008020080200;"),
    ("fast/grid.hpp", "return a | b << 10 | c << 20 | d << 30 | e << 40 | f << 50;"),
    ("fast/grid.hpp", "return ((range - part) & free_bits) == free_bits;"),
    ("fast/grid_probe.hpp", "margin = Lanes::all(2 * coordinate_error);"),
    ("fast/grid_probe.hpp", "low = lesser(one, other) - margin, high = greater(one, other) + margin;"),
    ("fast/grid_probe.hpp", "places_ = (first_halves(low, high) - origin) * Lanes::all(grid.per_metre);"),
    ("fast/grid_probe.hpp", "(places_ - Lanes::four(column, row, column, row)) * Lanes::all(Stretches::last_place + 1);"),
    ("fast/grid_probe.hpp", "lesser(greater(parts, Lanes::all(0)), Lanes::all(Stretches::last_place))"),
    ("fast/grid_probe.hpp", "lesser(greater(heights, Lanes::all(0)), Lanes::all(Stretches::last_place))"),
    ("fast/pairs.hpp", "return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];"),
    ("fast/surface_in_doubles.hpp", "const double difference = b - a, margin = 0x1p-44 * sizes;"
                                    " if (difference > margin) return true; if (difference < -margin) return false;"),
    ("fast/surface_in_doubles.hpp", "return is_at_most(least, got, (least + got) + (1 + t_squared) * length_squared);"),
    ("fast/surface_in_doubles.hpp", "return is_at_most(got, limit, got + limit + n_squared_ * force_squared_);"),
    ("fast/surface_in_doubles.hpp", "return is_at_most(along_squared, band, (along_squared + band) + floor);"),
    ("fast/surface_in_doubles.hpp", "return is_at_most(turning_squared, limit, (turning_squared + limit) + disc_floor());"),
    ("fast/surface_in_doubles.hpp", "is_at_most(limit, band, (limit + band) + disc_floor());"),
    ("fast/surface_in_doubles.hpp", "is_at_most(across_squared, g_squared_ * corner,"
                                    " (across_squared + g_squared_ * (limit + band)) + g_squared_ * disc_floor());"),
    ("fast/surface_in_doubles.hpp", "is_at_most(over, along_squared * corner, (over + along_squared * (limit + band)) +"
                                    " (g_squared_ * force_squared_) * (4 * (limit + band) + 4 * disc_floor()));"),
    ("fast/surface_in_doubles.hpp", "return friction_squared_ * (down_ * down_);"),
    ("fast/surface_in_doubles.hpp", "return (1 + friction_squared_) * (n_squared_ * force_squared_);"),
    ("fast/support.hpp", "return Support((a.next() & b.previous()) | (a.previous() & b.next()));"),
    ("fast/support.hpp", "return (axes_ >> 1 | axes_ << 2) & all_axes;"),
    ("fast/support.hpp", "return (axes_ >> 2 | axes_ << 1) & all_axes;"),
    ("fast/support.hpp", "const Support rightward = may_pull_across() ? cross(forward, normal) : Support();"),
    ("fast/support.hpp", "return has_brake ? force | forward : rightward | normal;"),
    ("fast/support.hpp", "return (has_brake ? forward : Support()) | rightward | normal;"),
    ("fast/support.hpp", "return has_friction ? force | normal : normal;"),
    ("fast/surface_in_pairs.hpp", "clipping == Clipping::onto_corner ?"
                                  " ask.friction * (1 + decided.corner_condition()) : ask.friction;"
                                  " return 0x1p-84 * (ask.force_size * (1 + of_disc));"),
    ("fast/hierarchy.cpp", "const auto rounded = static_cast<float>(x);"
                           " return double{rounded} <= x ? rounded : std::nextafter(rounded, -greatest_float);"),
    ("fast/exact_stage/strut.cpp", "ends.coordinate_error = 0x1p-53 * ends.greatest_coordinate() + 0x1p-1000;"),
    ("fast/step_strut.hpp", "const double error = component.error() + 0x1p-52 * std::abs(end[axis]);"),
    ("fast/box_search_body.hpp", "way.inverse[axis] * (1 + 0x1p-20F)"),
    ("fast/box_search_body.hpp", "near = greater((near_side - at.near_origin) * at.inverse, near);"),
    ("fast/box_search_body.hpp", "far = lesser((far_side - at.far_origin) * at.stretched, far);"),
    ("fast/search_kernels_body.hpp", "if (meeting.lower > result.upper) return true;"),
    ("fast/search_kernels_body.hpp", "if (meeting.upper < result.upper) result.upper = meeting.upper;"),
    ("fast/search.cpp", "if (contender.meeting.lower <= upper) contenders[kept++] = contender;"),
    ("fast/undecided.cpp", "const bool holds = (leaf.turn == Turn::enters && leaf.upper < contender.meeting.lower) ||"
                           " (leaf.turn == Turn::leaves && leaf.lower > upper);"),
    ("fast/sieved.cpp", "if (a < -error && b < -error) return Truth::yes; if (a > error && b > error) return Truth::no;"),
    ("fast/box.cpp", "bound += 8 * unit * size + tiny;"),
    ("fast/box.cpp", "best.bound = std::min(best.bound, bound + 2 * unit * magnitude(bound) + tiny);"),
    ("fast/paint.cpp", "const double at_lower = a + place_.lower * (b - a), at_upper = a + place_.upper * (b - a);"),
    ("fast/box.cpp", "slack[k] = magnitude(rest[k]) + 8 * unit * rest_size[k] + tiny;"),
    ("fast/box.cpp", "if (one > 0) limit += one * reach * (1 + 4 * unit); limit += 4 * unit * magnitude(limit);"),
    ("fast/box.cpp", "const double greatest = sum + 8 * unit * size + tiny;"),
    ("fast/cell.cpp", "const double inverse = 1 / w, middle = delta_at_first * inverse, margin = error * std::abs(inverse);"),
]


def value_of_hex(text):
    return Fraction(float.fromhex(text))


def value_in_lemma(text):
    """Of `17 * u`, `257 / 256`, `bpow radix2 (-960)`."""
    power = re.fullmatch(r"bpow radix2 \(?(-?\d+)\)?", text)
    if power:
        return Fraction(2) ** int(power[1])
    value = Fraction(1)  # `/ 1024` is a number too
    for sign, factor in re.findall(r"([*/]?)\s*(\w+)", text):
        number = Fraction(1, 2**53) if factor == "u" else Fraction(int(factor))
        value = value / number if sign == "/" else value * number
    return value


def one_space(text):
    return re.sub(r"\s+", " ", text)


class Constants(unittest.TestCase):
    def test_constants_are_those_of_the_lemmas(self):
        for source, around, lemma, name in CONSTANTS:
            with self.subTest(source=source, name=name):
                found = re.findall(around, one_space((ROOT / source).read_text()))
                self.assertTrue(found, f"{source}: nothing reads like {around}")
                defined = re.search(rf"Definition {name} := ([^.]*)\.", (LEMMAS / lemma).read_text())
                self.assertTrue(defined, f"{lemma}: no definition of {name}")
                for text in found:
                    self.assertEqual(value_of_hex(text), value_in_lemma(defined[1]),
                                     f"{source}: {text}, but {lemma}: {name} := {defined[1]}")

    def test_expressions_are_those_of_the_lemmas(self):
        for source, expression in EXPRESSIONS:
            with self.subTest(source=source):
                self.assertIn(one_space(expression), one_space((ROOT / source).read_text()))

    def test_numbers_of_lemmas_are_read(self):
        self.assertEqual(value_in_lemma("17 * u"), Fraction(17, 2**53))
        self.assertEqual(value_in_lemma("257 / 256"), value_of_hex("0x1.01p0"))
        self.assertEqual(value_in_lemma("bpow radix2 (-960)"), value_of_hex("0x1p-960"))


if __name__ == "__main__":
    unittest.main()

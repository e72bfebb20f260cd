#pragma once
// Short texts that the page of text and the page of HTML share. Private to this folder.

#include <string>
#include <utility>
#include <vector>

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::page {

using explanation::ClipFacts;
using explanation::EntryFacts;
using explanation::Explanation;
using explanation::Flip;
using explanation::Rational;
using explanation::Stop;

std::string words_of(const Vector& v);                    // "(0, 0, 1)"
std::string words_of(const Stop& stop);                   // "1/4", "between 1/4 and 1/2"
std::string formula_of(const explanation::Plane& plane);  // "z <= 1", "3x - 2y <= 0.5"
std::string name_of(const std::optional<MaterialIndex>& material, const Scene& scene);

// A name and a value.
using Line = std::pair<std::string, std::string>;

// lambda as fraction, decimal and hex float, and the point; empty on a miss.
std::vector<Line> lambda_lines(const Explanation& explanation);

// "0.5 more offset (1/2, a plane moved by 0.5 m) on leaf 3: a miss"
std::string words_of(const Flip& flip, const EntryFacts& facts);
// What is said of the search where it found nothing, or not all.
std::string words_of_search(const EntryFacts& facts);

// The case, the force in surface coordinates, and how far each border is.
std::vector<Line> clip_lines(const ClipFacts& facts);

}  // namespace groundtruth::page

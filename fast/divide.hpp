#pragma once
// From the solid's expression to its parts and their index. Not installed.

#include <groundtruth/fast/box.hpp>
#include <groundtruth/fast/compile_options.hpp>
#include <groundtruth/fast/expression.hpp>
#include <groundtruth/fast/parts.hpp>

namespace groundtruth::fast {

// Constants folded away; a lone operand is the operator's value. The leaves stay as they are.
std::vector<Node> fold(const Expression& solid);

// Certainly around the expression below the node (lemma box-by-duality, box.hpp).
Box box_around(const Expression& expression, const Node* node);

Parts divide(const Expression& solid, const CompileOptions& options, std::vector<LeftOut>& left_out);

}  // namespace groundtruth::fast

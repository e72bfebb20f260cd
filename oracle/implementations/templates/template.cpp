// Answers entry asks, in doubles. Copy it and put your own implementation in place of entry(). As a program:
// g++ -std=c++20 template.cpp -o template; as a library: g++ -std=c++20 -shared -fPIC template.cpp -o template.so
// A line in, a line out, flushed. Not done here: materials, clip, step; a start on a face that is left is inside.
#include <rapidjson/document.h>
#include <cmath>
#include <iostream>
#include <vector>
using Json = rapidjson::Value;
struct Face { double normal[3], lambda; bool is_entered; };
struct Inside { double since; std::size_t leaf; };  // the lambda and leaf of entry; +infinity: outside

// Is the line in the shape at this lambda? Its faces are added in the order in which leaves are numbered.
Inside inside(const Json& shape, const Json& ask, double at, std::vector<Face>& faces) {
  if (shape.IsString()) return {shape == "everything" ? -INFINITY : INFINITY, 0};
  if (shape.HasMember("shape")) return inside(shape["shape"], ask, at, faces);  // with a material
  if (shape.HasMember("halfspace")) {
    const Json &plane = shape["halfspace"], &from = ask["from"], &to = ask["to"];
    double distance = -plane[3].GetDouble(), slope = 0;
    for (unsigned i = 0; i < 3; ++i) distance += plane[i].GetDouble() * from[i].GetDouble();
    for (unsigned i = 0; i < 3; ++i) slope += plane[i].GetDouble() * (to[i].GetDouble() - from[i].GetDouble());
    const double lambda = -distance / slope;
    faces.push_back({{plane[0].GetDouble(), plane[1].GetDouble(), plane[2].GetDouble()}, lambda, slope < 0});
    const bool is_outside = slope == 0 ? distance > 0 : slope < 0 ? at < lambda : at > lambda;
    return {is_outside ? INFINITY : slope < 0 ? lambda : -INFINITY, faces.size() - 1};
  }
  const bool is_union = shape.HasMember("union"); Inside result{is_union ? INFINITY : -INFINITY, 0};
  for (const Json& part : shape[is_union ? "union" : "intersection"].GetArray()) {
    const Inside in_part = inside(part, ask, at, faces);
    if (is_union ? in_part.since < result.since : in_part.since > result.since) result = in_part;
  }
  return result;
}
std::string entry(const Json& shape, const Json& ask) {
  std::vector<Face> faces;
  const double near = ask["range"][0].GetDouble(), far = ask["range"][1].GetDouble();
  Inside hit = inside(shape, ask, near, faces);
  for (const Face& face : faces) {
    if (!face.is_entered || face.lambda < near || face.lambda > far || face.lambda >= hit.since) continue;
    std::vector<Face> same;
    if (const Inside there = inside(shape, ask, face.lambda, same); there.since < INFINITY) hit = there;
  }
  if (hit.since == INFINITY) return R"({"kind":"miss"})";
  const char* border = R"({"kind":"border","lambda":%.17g,"leaf":%zu,"normal":[%.17g,%.17g,%.17g],"material":null})";
  const double* n = faces[hit.leaf].normal; char text[256];
  if (hit.since < near) std::snprintf(text, 256, R"({"kind":"inside","lambda":%.17g})", near);
  else std::snprintf(text, 256, border, hit.since, hit.leaf, n[0], n[1], n[2]);
  return text;
}

extern "C" const char* groundtruth_answer(const char* text) {  // null if no answer is due
  static rapidjson::Document scene, line; static std::string answer;
  if (line.Parse(text).HasMember("hello")) return R"({"hello":"answers/1","name":"template.cpp","asks":["entry"]})";
  if (line.HasMember("scene")) return line.Swap(scene), nullptr;
  answer = R"({"id":")" + std::string(line["id"].GetString()) + R"(","answer":)" + entry(scene["scene"]["shape"], line) + "}";
  return answer.c_str();
}
int main() {
  for (std::string line; std::getline(std::cin, line);)
    if (const char* answer = groundtruth_answer(line.c_str())) std::cout << answer << std::endl;
}

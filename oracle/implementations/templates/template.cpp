// Answers entry asks, in doubles. Copy it and put your own implementation in place of entry(). As a program:
// g++ -std=c++20 template.cpp -o template; as a library: g++ -std=c++20 -shared -fPIC template.cpp -o template.so
// A line comes in, a line goes out, flushed: hello, then scenes and asks. Not done here: materials, clip, step.
#include <rapidjson/document.h>

#include <iostream>
#include <vector>

using Json = rapidjson::Value;
struct Face { double normal[3], lambda; bool is_entered; };

// Does the shape hold the point at this lambda? Its faces are added in the order in which leaves are numbered.
bool contains(const Json& shape, const Json& ask, double at, std::vector<Face>& faces) {
  if (shape.IsString()) return shape == "everything";
  if (shape.HasMember("halfspace")) {
    const Json& plane = shape["halfspace"];
    double distance = -plane[3].GetDouble(), slope = 0;
    for (int i = 0; i < 3; ++i) {
      distance += plane[i].GetDouble() * ask["from"][i].GetDouble();
      slope += plane[i].GetDouble() * (ask["to"][i].GetDouble() - ask["from"][i].GetDouble());
    }
    const double lambda = -distance / slope;
    faces.push_back({{plane[0].GetDouble(), plane[1].GetDouble(), plane[2].GetDouble()}, lambda, slope < 0});
    return slope == 0 ? distance <= 0 : slope < 0 ? at >= lambda : at <= lambda;
  }
  const bool is_union = shape.HasMember("union"); bool result = !is_union;
  for (const Json& part : shape[is_union ? "union" : "intersection"].GetArray())
    if (contains(part, ask, at, faces) == is_union) result = is_union;
  return result;
}

std::string entry(const Json& shape, const Json& ask) {
  std::vector<Face> faces, unused;
  const double near = ask["range"][0].GetDouble(), far = ask["range"][1].GetDouble();
  const bool is_inside = contains(shape, ask, near, faces);
  const Face* hit = nullptr;
  for (const Face& face : faces) {
    const bool is_next = face.is_entered && face.lambda >= near && face.lambda <= (hit ? hit->lambda : far);
    if (is_next && contains(shape, ask, face.lambda, unused)) hit = &face;
  }
  char text[256] = R"({"kind":"miss"})";
  const char* border = R"({"kind":"border","lambda":%.17g,"leaf":%td,"normal":[%.17g,%.17g,%.17g],"material":null})";
  if (is_inside && (!hit || hit->lambda > near)) std::snprintf(text, 256, R"({"kind":"inside","lambda":%.17g})", near);
  else if (hit) std::snprintf(text, 256, border, hit->lambda, hit - &faces[0], hit->normal[0], hit->normal[1], hit->normal[2]);
  return text;
}

extern "C" const char* groundtruth_answer(const char* text) {  // null if no answer is due
  static rapidjson::Document scene, line;
  static std::string answer;
  if (line.Parse(text).HasMember("hello")) return R"({"hello":"answers/1","name":"template.cpp","asks":["entry"]})";
  if (line.HasMember("scene")) return line.Swap(scene), nullptr;
  answer = R"({"id":")" + std::string(line["id"].GetString()) + R"(","answer":)" + entry(scene["scene"]["shape"], line) + "}";
  return answer.c_str();
}

int main() {
  for (std::string line; std::getline(std::cin, line);)
    if (const char* answer = groundtruth_answer(line.c_str())) std::cout << answer << std::endl;
}

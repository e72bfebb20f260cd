#include <groundtruth/implementations/engine.hpp>

#include <groundtruth/implementations/adapters.hpp>

namespace groundtruth::implementations {

std::unique_ptr<const Engine> make_engine(std::string_view name, unsigned digits) {
  constexpr std::string_view errata_prefix = "as-written:";
  if (name == "exact") return make_exact_engine(digits);
  if (name == "definition") return make_definition_engine();
  if (name == "fast") return make_fast_engine();
  if (name == "double") return make_double_engine();
  if (name == "proved") return make_proved_engine();
  if (name == "as-written") return make_as_written_engine("");
  if (name.starts_with(errata_prefix) && name != errata_prefix) {
    return make_as_written_engine(name.substr(errata_prefix.size()));
  }
  return nullptr;
}

std::vector<std::string> engine_names() { return {"exact", "definition", "fast", "double", "as-written"}; }

}  // namespace groundtruth::implementations

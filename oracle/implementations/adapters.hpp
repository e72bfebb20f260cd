#pragma once
// One factory an engine; each is defined in the only file that includes that engine. Private to this folder.

#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::implementations {

std::unique_ptr<const Engine> make_exact_engine(unsigned digits);
std::unique_ptr<const Engine> make_definition_engine();
std::unique_ptr<const Engine> make_fast_engine();
// The plain double engine is the source's without any of its errata.
std::unique_ptr<const Engine> make_double_engine();
// Entry asks only, put to the program proved-phi. Absent: it cannot be started.
std::unique_ptr<const Engine> make_proved_engine();
// `errata`: names joined by commas; empty: all of them. Absent: one of them is unknown.
std::unique_ptr<const Engine> make_as_written_engine(std::string_view errata);

}  // namespace groundtruth::implementations

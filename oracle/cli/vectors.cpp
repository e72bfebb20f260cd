#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/core.h>

#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/report/vector_files.hpp>

#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text << std::flush;
  if (!stream) throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
}

Exit run(const std::string& folder) {
  std::filesystem::create_directories(folder);
  for (const report::VectorFile& file : report::vector_files(cases::corpus())) {
    write_file(std::filesystem::path(folder) / file.name, file.text);
  }
  fmt::print("{} cases in {}\n", cases::corpus().size(), folder);
  return Exit::agrees;
}

}  // namespace

Subcommand add_vectors(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("vectors", "Writes the worst known cases with their exact answers into files");
  const auto folder = std::make_shared<std::string>();
  command->add_option("--out", *folder, "The folder to write into; made if there is none")->required();
  return {command, [folder] { return run(*folder); }};
}

}  // namespace groundtruth::cli

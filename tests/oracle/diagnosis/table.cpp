// diagnosis_table [errata|slips|planted]: what the diagnosis names for each erratum and each two of them, for
// each classic slip around the exact engine, and for each planted mistake.

#include <chrono>
#include <cstdio>
#include <string>

#include <fmt/core.h>

#include "../../planted/planted_engine.hpp"
#include "slipping.hpp"
#include "witnessing.hpp"

namespace groundtruth::diagnosis {
namespace {

void print_row(const Asking& asking, const std::string& name, const implementations::Engine& subject) {
  const Judged judged = asking.judge(subject);
  const auto begin = std::chrono::steady_clock::now();
  const auto diagnosis = diagnose(judged.failures, judged.accepted);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  const Diagnosis shown = diagnosis.value_or(Diagnosis{});
  fmt::print("{:52} {:5} failures {:5} accepted {:5.2f} s  {:5} explained {}/{} contradicted {}/{}  {}\n",
             name, judged.failures.size(), judged.accepted.size(), time.count(),
             names(diagnosis, name) ? "right" : "", shown.explained, shown.failures, shown.contradicted,
             shown.accepted, told(diagnosis));
  std::fflush(stdout);
}

void print_errata(const Asking& asking) {
  for (auto list : {errata(), pairs_of_errata()})
    for (const Suspect& erratum : list) print_row(asking, erratum.name, *engine_of(erratum));
}

void print_slips(const Asking& asking) {
  for (const Suspect& slip : classic_slips()) print_row(asking, slip.name, *engine_of(slip));
}

void print_planted(const Asking& asking) {
  for (const planted::Bug& bug : planted::all_bugs())
    print_row(asking, std::string(bug.name), *planted::make_engine_of(bug.name, bug.on));
}

}  // namespace
}  // namespace groundtruth::diagnosis

int main(int count, char** arguments) {
  using namespace groundtruth::diagnosis;
  const Asking asking(30);
  const std::string which = count > 1 ? arguments[1] : "";
  if (which.empty() || which == "errata") print_errata(asking);
  if (which.empty() || which == "slips") print_slips(asking);
  if (which.empty() || which == "planted") print_planted(asking);
}

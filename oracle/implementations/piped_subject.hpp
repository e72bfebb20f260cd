#pragma once
// A Subject over the pipes of a process. Private to this folder.

#include <groundtruth/implementations/keeper.hpp>
#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations {

// `entry` runs in the process, with the implementation's standard streams.
SubjectOrNone piped_subject(Entry entry, const Patience& patience);

}  // namespace groundtruth::implementations

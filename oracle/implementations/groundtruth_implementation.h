/* What a shared library offers to be judged by `groundtruth`: one function. C99.
 *
 * It is the protocol of programs, a line at a time: hello, scenes and asks come as they would on standard
 * input, and what would go to standard output is returned.
 *
 * The library is loaded into a process of its own, and called from one thread. What it prints to standard
 * output or standard error is shown as its last words and is no answer. It may crash or hang: that is a
 * verdict about the ask, and the library is loaded anew for the next one. */
#ifndef GROUNDTRUTH_IMPLEMENTATION_H
#define GROUNDTRUTH_IMPLEMENTATION_H

#ifdef __cplusplus
extern "C" {
#endif

/* The line that answers `line`, both JSON without line end and ended by a NUL, in UTF-8; NULL if none is due,
 * as for a scene. The result stays the library's, and must stay valid until the next call. */
const char* groundtruth_answer(const char* line);

#ifdef __cplusplus
}
#endif

#endif

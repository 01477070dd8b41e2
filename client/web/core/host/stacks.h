#pragma once

#include <functional>

namespace burnish {

// Work that waits without a thread: it runs on a stack of its own, which the browser suspends and
// resumes. One stack runs at a time, and another one goes on only where one waits or ends.

/// Begins work on a stack of its own, not within this call.
void start_stack(std::function<void()> work);

/// Returns the number of the stack that runs; 0: the worker's own, which must not wait.
int this_stack();

/// Waits until resume_stack() is called for this stack, or has been since the last wait. May return
/// without it: look again at what was waited for. Needs: this_stack() != 0.
void wait_on_stack();

void resume_stack(int stack);

}  // namespace burnish

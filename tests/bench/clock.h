#pragma once

namespace burnish {

/// Additions a nanosecond in a chain, of the slowest of this thread's parallel threads: a core does
/// one a cycle, so this is its clock, less what the machine's host takes away. Frame times are only
/// alike where it is: a shared machine's cores may run at little more than half their clock for
/// minutes, which the triad, bound by memory, does not show.
double core_gigahertz();

}  // namespace burnish

#pragma once

namespace burnish {

/// Returns additions per nanosecond in a chain, of the slowest of this thread's parallel threads. A
/// core does one per cycle, so this is its clock, less the time that the machine's host takes away.
/// Compare frame times only at the same clock. A shared machine's cores may run at little more than
/// half their clock for minutes. The triad, bound by memory, does not show it.
double core_gigahertz();

}  // namespace burnish

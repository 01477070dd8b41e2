#pragma once

namespace burnish {

/// Returns whether an input has ended: nobody holds the other end of the pipe any more. Reads and
/// drops what has come. Never waits.
bool has_ended(int input);

}  // namespace burnish

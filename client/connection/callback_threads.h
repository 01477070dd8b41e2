#pragma once

namespace burnish {

/// Keeps gRPC's threads for callbacks, once they are there, as long as the process lives. gRPC 1.51
/// ends them with the last channel that needs them, and aborts when that happens on one of them: a
/// stream that outlives its channel's other owners ends exactly there.
void keep_callback_threads();

}  // namespace burnish

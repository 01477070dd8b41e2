#pragma once

namespace burnish {

/// Lets the threads of parallel loops sleep while they wait for each other. By default they spin,
/// which is slow when the program shares its cores: a frame of 35 ms takes 93 ms beside one busy
/// process and 400 ms beside three. With sleeping threads it takes 70 ms beside one. Call it first
/// in main(): OpenMP reads its settings before main(), so the program starts itself again. Does
/// nothing if OMP_WAIT_POLICY or GOMP_SPINCOUNT is set.
void sleep_while_waiting(char** argv);

}  // namespace burnish

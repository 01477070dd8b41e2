#pragma once

namespace burnish {

/// Lets the threads of parallel loops sleep while they wait for each other; by default they spin,
/// and a program that shares its cores with others then takes many times as long (a frame of 35 ms
/// 70 beside one busy process instead of 93, and 400 beside three). The first thing in main():
/// OpenMP reads its settings before that, so the program starts itself once more. Does nothing
/// where OMP_WAIT_POLICY or GOMP_SPINCOUNT say what is wanted.
void sleep_while_waiting(char** argv);

}  // namespace burnish

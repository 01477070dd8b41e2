// Linked into every program of a ThreadSanitizer build. libtsan of g++ 12 does not see the function
// by which std::timed_mutex waits, and reports each later unlock as one of an unlocked mutex. Here
// that function waits by one that the tool sees.

#include <ctime>
#include <pthread.h>

static constexpr long kNanosPerSecond = 1'000'000'000;

static timespec now(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return time;
}

extern "C" int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                       const timespec* deadline) {
  const timespec passed = now(clock);
  timespec end = now(CLOCK_REALTIME);
  end.tv_sec += deadline->tv_sec - passed.tv_sec;
  end.tv_nsec += deadline->tv_nsec - passed.tv_nsec;
  if (end.tv_nsec < 0) {
    end.tv_nsec += kNanosPerSecond;
    --end.tv_sec;
  } else if (end.tv_nsec >= kNanosPerSecond) {
    end.tv_nsec -= kNanosPerSecond;
    ++end.tv_sec;
  }
  return pthread_mutex_timedlock(mutex, &end);
}

#pragma once

namespace burnish {

/// Tells how long a processor worked on the parts of a work, where only the time of day is known.
/// Other programs interrupt some parts, which then take longer by all that these do: such a part
/// counts as the mean of the others.
class PartTimes {
 public:
  void add(double part_seconds) {
    ++parts_;
    sum_ += part_seconds;
    if (part_seconds > kWholeSecondsMax) return;
    ++whole_;
    whole_sum_ += part_seconds;
  }

  /// Returns the seconds of all parts. Most long parts together are a slow processor's own.
  double seconds() const {
    if (2 * whole_ <= parts_) return sum_;
    return whole_sum_ * parts_ / whole_;
  }

 private:
  static constexpr double kWholeSecondsMax = 0.002;  // less than programs get at a time

  int parts_ = 0, whole_ = 0;  // whole: not interrupted
  double sum_ = 0, whole_sum_ = 0;
};

}  // namespace burnish

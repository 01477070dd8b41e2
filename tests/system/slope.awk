# Measures how fast a value grows: reads lines "seconds megabytes" and prints the slope in MB an
# hour, with the medians at both ends. The first third is for warming up and does not count. Fails
# if the value grows faster than both `limit` MB an hour and `floor` MB within the counted time: in
# a short run an allocator may keep `floor` MB. Usage: awk -v limit=10 -v floor=4 -f slope.awk

{ seconds[NR] = $1; value[NR] = $2 }

function sort(array, n,    i, j, held) {
  for (i = 2; i <= n; ++i) {
    held = array[i]
    for (j = i - 1; j > 0 && array[j] > held; --j) array[j + 1] = array[j]
    array[j + 1] = held
  }
}

function median(array, n) {
  sort(array, n)
  return n % 2 ? array[(n + 1) / 2] : (array[n / 2] + array[n / 2 + 1]) / 2
}

function median_of(first, last,    part, n, i) {
  for (i = first; i <= last; ++i) part[++n] = value[i]
  return median(part, n)
}

END {
  if (NR < 6) { print "slope: " NR " readings are too few to judge, 6 are needed"; exit 2 }
  first = int(NR / 3) + 1
  for (i = first; i <= NR; ++i)  # Theil and Sen: a few readings that are off do not count
    for (j = i + 1; j <= NR; ++j)
      slopes[++n] = (value[j] - value[i]) / (seconds[j] - seconds[i]) * 3600
  slope = median(slopes, n)
  hours = (seconds[NR] - seconds[first]) / 3600
  allowed = limit > floor / hours ? limit : floor / hours
  end = int((NR - first + 1) / 3)
  printf "resident memory over the last %.1f min, %d readings: median %.1f MB at first, %.1f MB in the end; %+.1f MB an hour, limit %.1f\n",
         hours * 60, NR - first + 1, median_of(first, first + end - 1), median_of(NR - end + 1, NR), slope, allowed
  exit slope > allowed
}

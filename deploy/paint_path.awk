# Chooses a path across the broad side of a scan for a brush, and the side to look at it from.
# Usage: awk -f paint_path.awk SCAN.obj SCAN.obj       (the box first, then the points)
# Writes a stroke file: "# view AZIMUTH,ELEVATION", "# diagonal D", then one "x y z" a line.
#
# The path has 24 stations along the longest side of the bounding box, from a fifth to four fifths.
# Each station takes the vertex that is nearest to the middle of the second side and highest along
# the third.

$1 != "v" { next }

NR == FNR {
  for (axis = 1; axis <= 3; ++axis) {
    x = $(axis + 1) + 0
    if (!vertices || x < low[axis]) low[axis] = x
    if (!vertices || x > high[axis]) high[axis] = x
  }
  ++vertices
  next
}

!ready { ready = 1; measure() }

{
  station = int((($(along + 1) - low[along]) / extent[along] - 0.2) / 0.6 * 24)
  if (station < 0 || station >= 24) next
  off_middle = ($(across + 1) - low[across]) / extent[across] - 0.5
  height = ($(up + 1) - low[up]) / extent[up]
  score = height - 10 * (off_middle < 0 ? -off_middle : off_middle)
  if (!(station in best) || score > best[station]) {
    best[station] = score
    point[station] = $2 " " $3 " " $4
  }
}

END {
  view[1] = "70,20"; view[2] = "20,60"; view[3] = "20,25"
  print "# view " view[up]
  print "# diagonal " sqrt(extent[1] ^ 2 + extent[2] ^ 2 + extent[3] ^ 2)
  for (station = 0; station < 24; ++station) if (station in point) print point[station]
}

function measure(    axis) {
  along = up = 1
  for (axis = 1; axis <= 3; ++axis) {
    extent[axis] = high[axis] - low[axis]
    if (extent[axis] > extent[along]) along = axis
    if (extent[axis] <= extent[up]) up = axis
  }
  if (along == up) up = along % 3 + 1  # a cube: any two sides do
  across = 6 - along - up
  for (axis = 1; axis <= 3; ++axis) if (extent[axis] == 0) extent[axis] = 1  # a flat sheet
}

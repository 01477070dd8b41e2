# Smoothed everywhere, and sharpened again under the brush.

load "style.gp"

title(picture) = picture eq "original" ? "as scanned" : \
  picture eq "smoothed" ? "α ".alpha(picture).", β ".beta(picture) : \
  picture eq "brushed" ? "three strokes of β 3" : "β of the cells: blue 0, grey 1, red above"

eval sheet("figure5", 4, 1)
set multiplot layout 1,4 title scan.": selective sharpening (Figure 5)" font ",14" noenhanced
do for [picture in "original smoothed brushed painted"] {
  set title title(picture)
  eval draw
}
unset multiplot

# Two fidelities, two gradient scales, and the scan between them.

load "style.gp"

eval sheet("figure2", 3, 2)
set multiplot layout 2,3 title scan.": fidelity and gradient scale (Figure 2)" font ",14" noenhanced
do for [picture in "low-2 farther high-2 low-0 settings high-0"] {
  if (picture eq "settings") {
    set title ""
    set label 1 "α says which detail:\n\nthe larger, the finer.\n\n\nβ says what becomes of it:\n\n\
0 removes, 1 keeps, 2 doubles." at graph 0.18, 0.72
    plot [0:1] [0:1] NaN notitle
    unset label 1
  } else {
    set title picture eq "farther" ? "as scanned (β 1)" : \
        "α ".alpha(picture).", β ".beta(picture)
    eval draw
  }
}
unset multiplot

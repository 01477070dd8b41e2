# Plots the largest (thick) and root-mean-square (thin) distance of the vertices from the converged
# surface, by cycle and by time on the CPU; a sheet of all cases for each scan.

load "style.gp"

smoothers = distinct("smoothers", "smoother")
cases = distinct("smoothers", "case")
scans = distinct("smoothers", "scan")
title_of(name) = system(sprintf("printf %%s '%s' | sed 's/_/, /; s/-/ /g'", name))
row(c, smoother) = is("scan", scan) && is("case", c) && is("backend", "cpu") && is("smoother", smoother)

set logscale y
set format y power_of_ten
set yrange [1e-9:]
set xrange [0:*]
do for [scan in scans] {
  do for [against in "cycle time_ms"] {
    by_time = against eq "time_ms"
    eval sheet("smoothers-".plain(scan).(by_time ? "-by-time" : "-by-cycle"), 1650, 900)
    set multiplot layout 2,3 margins screen 0.055, 0.86, 0.07, 0.91 spacing screen 0.04, 0.11 \
        title scan.": distance of the vertices from the converged surface over the diagonal of the box" font ",14" noenhanced
    do for [i = 1:words(cases)] {
      c = word(cases, i)
      set title title_of(c)
      set xlabel by_time ? "time in steps, ms" : "cycle"
      set ylabel (i % 3 == 1) ? "max (thick), rms (thin)" : ""
      if (i == 1) { eval key_beside } else { unset key }
      plot for [s = 1:words(smoothers)] table("smoothers") \
             using (only(row(c, word(smoothers, s)), column(against))):"max" \
             with lines linetype s linewidth 2 title word(smoothers, s), \
           for [s = 1:words(smoothers)] table("smoothers") \
             using (only(row(c, word(smoothers, s)), column(against))):"rms" \
             with lines linetype s linewidth 1 dashtype 2 notitle
    }
    unset multiplot
  }
}

# Largest (lines) and root-mean-square (dots) distance of the vertices from the converged surface,
# by cycle and by time; a sheet of all cases for each scan.

load "style.gp"

smoothers = distinct("smoothers", "smoother")
cases = distinct("smoothers", "case")
scans = distinct("smoothers", "scan")
title_of(name) = system(sprintf("printf %%s '%s' | sed 's/_/, /; s/-/ /g'", name))
row(c, smoother) = is("scan", scan) && is("case", c) && is("smoother", smoother)

set logscale y
set format y power_of_ten
set yrange [1e-9:]
set xrange [0:*]
do for [scan in scans] {
  do for [against in "cycle time_ms"] {
    by_time = against eq "time_ms"
    eval sheet("smoothers-".plain(scan).(by_time ? "-by-time" : "-by-cycle"), 1500, 900)
    set multiplot layout 2,3 title scan.": distance of the vertices from the converged surface over the diagonal of the box" font ",14" noenhanced
    do for [i = 1:words(cases)] {
      c = word(cases, i)
      set title title_of(c)
      set xlabel by_time ? "time in steps, ms" : "cycle"
      set ylabel (i % 3 == 1) ? "max (line), rms (dots)" : ""
      if (i == 1) { set key bottom left samplen 2 spacing 1.1 } else { set key off }
      plot for [s = 1:words(smoothers)] table("smoothers") \
             using (only(row(c, word(smoothers, s)), column(against))):"max" \
             with lines linetype s linewidth 2 title word(smoothers, s), \
           for [s = 1:words(smoothers)] table("smoothers") \
             using (only(row(c, word(smoothers, s)), column(against))):"rms" \
             with points linetype s pointtype 7 pointsize 0.4 notitle
    }
    unset multiplot
  }
}

# Plots the time of a step, a new constraint and a new matrix by the number of corners, and the time
# of memory alone (thin lines).

load "style.gp"

threads = distinct("cost", "threads")
count(n) = n.(n eq "1" ? " thread" : " threads")
calls = "step rhs matrix"
label(call) = call eq "step" ? "one step" : call eq "rhs" ? "new constraint" : "new matrix and constraint"

eval sheet("cost", 1500, 560)
set multiplot layout 1,3 title "Cost by size: default smoother, memory floor at the triad's bandwidth" font ",14"
set logscale xy
set format x power_of_ten
set format y "%g"
set xlabel "corners"
set key top left
do for [call in calls] {
  set title label(call)
  set ylabel call eq "step" ? "time, ms" : ""
  plot for [t = 1:words(threads)] table("cost") \
         using (only(is("threads", word(threads, t)), column("corners"))):(column(call."_ms")) \
         with linespoints linetype t linewidth 2 pointtype 7 \
         title count(word(threads, t)), \
       for [t = 1:words(threads)] table("cost") \
         using (only(is("threads", word(threads, t)), column("corners"))):(column(call."_floor_ms")) \
         with lines linetype t linewidth 1 dashtype 2 title "memory, ".count(word(threads, t))
}
unset multiplot

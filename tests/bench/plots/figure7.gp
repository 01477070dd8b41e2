# Plots frames per second in the three states on the CPU. The bar is all threads, its dark part is
# one thread. The point is all threads with the vertices evaluated here, not by the client.

load "style.gp"

smoothers = distinct("figure7", "smoother")
threads = distinct("figure7", "threads")
meshes = distinct("figure7", "mesh")
most = word(threads, words(threads))
bars = words(smoothers)
place(smoother) = sum [s = 1:bars] (word(smoothers, s) eq smoother ? s : 0)
at_smoother(condition) = only(condition && is("scan", scan) && is("backend", "cpu"), place(strcol("smoother")))
with_threads(t) = is("threads", t)

do for [mesh in meshes] {
  scans = distinct_where("figure7", "scan", "mesh", mesh)
  width = 310 + 300 * words(scans)
  eval sheet("figure7-".plain(mesh), width, 900)
  set multiplot layout 3,words(scans) margins screen 80.0 / width, 1 - 260.0 / width, 0.03, 0.92 \
      spacing screen 50.0 / width, 0.05 \
      title mesh.": frames per second by state, depth and smoother" font ",14" noenhanced
  set style fill solid 1 noborder
  set boxwidth 0.8
  set xrange [0.4:bars + 0.6]
  set yrange [0:*]
  unset xtics
  do for [state in "solve rhs matrix"] {
    do for [i = 1:words(scans)] {
      scan = word(scans, i)
      set title (state eq "solve") ? scan : "" noenhanced
      set ylabel (i == 1) ? state.": frames per second" : ""
      unset key
      if (state eq "solve" && i == 1) { eval key_beside }
      plot for [s = 1:bars] table("figure7") \
             using (at_smoother(with_threads(most) && is("smoother", word(smoothers, s)))):(column(state."_fps")) \
             with boxes linetype s title word(smoothers, s), \
           table("figure7") using (at_smoother(with_threads("1"))):(column(state."_fps")) \
             with boxes linecolor "#80000000" title "one thread", \
           table("figure7") using (at_smoother(with_threads(most))):(column(state."_evaluate_fps")) \
             with points pointtype 7 pointsize 1.2 linecolor "black" title "vertices evaluated here"
    }
  }
  unset multiplot
}

# Plots running time and accuracy by number of cycles: colours for depths, dashes for options. A
# sheet for each scan: the paper's W-cycles above, V-cycles in conjugate gradients below.

load "style.gp"

meshes = distinct("figure6", "mesh")
modes = distinct("figure6", "mode")
dash(mode) = mode eq "serial" ? 1 : mode eq "parallel" ? 2 : 3
row(s, m) = is("shape", shape) && is("scan", word(scans, s)) && is("mode", word(modes, m))
label(s, m) = word(scans, s).", ".word(modes, m)

do for [mesh in meshes] {
  scans = distinct_where("figure6", "scan", "mesh", mesh)
  eval sheet("figure6-".plain(mesh), 1500, 950)
  set multiplot layout 2,2 margins screen 0.06, 0.78, 0.07, 0.91 spacing screen 0.08, 0.11 \
      title mesh.": five Gauss-Seidel sweeps at each depth, from zero" font ",14" noenhanced
  set logscale y
  set xrange [0.5:*]
  set xtics 1
  do for [shape in "W V"] {
    what = shape eq "W" ? "W-cycles" : "V-cycles in conjugate gradients"
    do for [value in "time_ms residual"] {
      by_time = value eq "time_ms"
      set title what
      set xlabel "cycles"
      set ylabel by_time ? "time, ms" : "norm of the residual over the constraint's"
      set format y by_time ? "%g" : power_of_ten
      if (by_time || shape eq "V") { unset key } else { eval key_beside }
      plot for [s = 1:words(scans)] for [m = 1:words(modes)] table("figure6") \
             using (only(row(s, m), column("cycle"))):(column(value)) \
             with lines linetype s linewidth 2 dashtype dash(word(modes, m)) title label(s, m)
    }
  }
  unset multiplot
}

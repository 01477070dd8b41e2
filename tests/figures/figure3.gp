# Three transfer curves at β = 0: the surface keeps its place where α is high.

load "style.gp"

pictures = "original grooves ridges creases"
name(picture) = picture eq "original" ? "as scanned" : picture." hold, β ".beta(picture)
# Returns a curve's points, and its ends up to the edges of the plot.
points(picture) = system(sprintf( \
  "printf %%s '%s' | tr ',:' '\\n ' | awk '{ a = $2 } NR == 1 { print -100, a } { print } \
    END { print 100, a }'", curve(picture)))

eval sheet("figure3", 4, 2)
set multiplot layout 2,4 title scan.": transfer curves (Figure 3)" font ",14" noenhanced
do for [picture in pictures] {
  set title name(picture)
  eval draw
}
do for [picture in pictures] {
  set title picture eq "original" ? "" : "α(κ): ".curve(picture)
  if (picture eq "original") {
    set label 1 "κ: curvature, in units of the scan's size.\n\nConvex ridges to the right,\n\n\
concave grooves to the left.\n\n\nα: how strongly the surface holds\n\nin directions of that curvature." \
        at graph 0.08, 0.72
    plot [0:1] [0:1] NaN notitle
    unset label 1
  } else {
    set lmargin 7; set rmargin 2; set tmargin 2; set bmargin 4
    set border 3; set tics nomirror; set xlabel "κ"; set ylabel "α"; set logscale y
    set print $curve
    print points(picture)
    unset print
    plot [-100:100] [10:1000] $curve with lines linewidth 3 linecolor "#e07b00" notitle
    eval whole_tile
  }
}
unset multiplot

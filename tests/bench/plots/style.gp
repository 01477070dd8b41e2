# The common part of the sheets. Call them in this folder, with the folder of tables and sheets:
#     gnuplot -e "folder='/somewhere/bench'" figure7.gp

set datafile separator tab
set datafile columnheaders
set datafile missing NaN
set linetype 1 linecolor "#1f77b4"
set linetype 2 linecolor "#e07b00"
set linetype 3 linecolor "#2a9d54"
set linetype 4 linecolor "#c8358c"
set linetype 5 linecolor "#7a5cc4"
set linetype 6 linecolor "#8c6d3f"
set linetype 7 linecolor "#17a2b8"
set linetype 8 linecolor "#6b7280"
set linetype cycle 8
set grid back linecolor "#dddddd" linewidth 1
set border 3 back linecolor "#555555"
set tics nomirror textcolor "#333333"
power_of_ten = "10^{%T}"
set key noenhanced reverse Left samplen 2.5 spacing 1.15

table(name) = folder."/".name.".tsv"
sheet(name, width, height) = sprintf( \
  "set terminal pngcairo size %d,%d font 'sans,11'; set output '%s/%s.png'", \
  width, height, folder, name)

# One key for all panels of a sheet, next to them.
key_beside = "set key at screen 0.99, screen 0.9 right top"

# Returns the values of a column, each once, in order, from rows where another column is `text`.
distinct_where(name, column, other, text) = system(sprintf( \
  "awk -F '\\t' 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } \
    $at[\"%s\"] == \"%s\" && !seen[$at[\"%s\"]]++ { print $at[\"%s\"] }' '%s'", \
  other, text, column, column, table(name)))
distinct(name, column) = system(sprintf( \
  "awk -F '\\t' 'NR == 1 { while ($++c != \"%s\"); next } !seen[$c]++ { print $c }' '%s'", \
  column, table(name)))

# Returns a scan's name as part of a file's name.
plain(scan) = system(sprintf("printf %%s '%s' | tr -c 'A-Za-z0-9_.\n' '-'", scan))

# Returns a row's value if a column has a text, else nothing.
is(column, text) = strcol(column) eq text
only(condition, value) = condition ? value : NaN

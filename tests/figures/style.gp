# The common part of the sheets. Call them in this folder, with the folder of pictures and settings:
#     gnuplot -e "folder='/somewhere/figures'; scan='tablet'" figure2.gp

picture_width = 800
picture_height = 640
tile_width = 400
tile_height = 360  # the picture at half its size, and its caption

sheet(name, columns, rows) = sprintf( \
  "set terminal pngcairo size %d,%d font 'sans,11'; set output '%s/%s.png'", \
  columns * tile_width, rows * tile_height + 50, folder, name)

# Reads settings.tsv.
setting(picture, field) = system(sprintf( \
  "awk -F '\\t' '$1 == \"%s\" { print $%d }' '%s/settings.tsv'", picture, field, folder))
beta(picture) = setting(picture, 2)
curve(picture) = setting(picture, 3)
# Returns the α of a curve of one point.
alpha(picture) = system(sprintf("printf %%s '%s' | cut -d : -f 2", curve(picture)))

file(picture) = folder."/".picture.".png"
draw = "plot [0:picture_width - 1] [0:picture_height - 1] \
  file(picture) binary filetype=png with rgbimage notitle"
whole_tile = "set lmargin 0.6; set rmargin 0.6; set tmargin 2.4; set bmargin 0.4; \
  unset border; unset tics; unset key; unset xlabel; unset ylabel; unset logscale"
eval whole_tile
set title offset 0,-0.6 noenhanced

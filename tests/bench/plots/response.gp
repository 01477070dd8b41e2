# Plots how much is left of a wave on a sphere when one band of the equaliser is silent: points as
# measured, lines by the formula. All lengths are over the second band's size.

load "style.gp"

behind(size, wave) = 1 / (1 + (size / wave) ** 2)
left(band, wave) = 1 - (band == 1 ? 1 - behind(0.4, wave) : \
                        band == 2 ? behind(0.4, wave) - behind(1, wave) : \
                                    behind(1, wave) - behind(2.5, wave))

eval sheet("response", 1000, 560)
set title "Bands that end at 0.4, 1 and 2.5, one of them silent, on a sphere" font ",14"
set logscale x
set xrange [0.2:6]
set yrange [0:1.05]
set xlabel "wavelength"
set ylabel "left of the wave"
set key bottom right
plot for [band = 1:3] left(band, x) with lines linetype band linewidth 2 \
       title "formula, band ".band." silent", \
     for [band = 1:3] table("response") \
       using (column("silent_band") == band ? column("wavelength") : NaN):(column("found")) \
       with points linetype band pointtype 7 pointsize 1.4 title "measured, band ".band." silent"

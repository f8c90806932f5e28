# Run in this folder by: gnuplot -d energy-box.gp
csv = "../data/figure-energy-box.csv"
if (!exists('svg')) svg = "energy-box.svg"
if (!exists('png')) png = "energy-box.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set xrange [-0.12:6.12]
at_x(v) = v < -0.11999375999999999 ? -0.11999375999999999 : v > 6.11999376 ? 6.11999376 : v
set format y '%g'
set logscale y
set ytics ('' 1e-17 1, '10^{-16}' 1e-16, '' 1e-15 1, '10^{-14}' 1e-14, '' 1e-13 1, '10^{-12}' 1e-12, '' 1e-11 1, '10^{-10}' 1e-10, '' 1e-9 1, '10^{-8}' 1e-8, '' 1e-7 1, '10^{-6}' 1e-6)
set yrange [6.025595860743593e-18:1.6595869074375596e-06]
at_y(v) = v < 6.025754586510156e-18 ? 6.025754586510156e-18 : v > 1.6595431918828887e-06 ? 1.6595431918828887e-06 : v
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "time, s" noenhanced textcolor rgb ink
set ylabel "\174change of energy\174 / energy at the start" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "energy_box"
set output svg
plot csv skip 1 every ::0::120 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::0::120 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 7 pointsize 0.4 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.4 linecolor rgb "#56b4e9" title "custom-continuous", \
     csv skip 1 every ::121::241 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::121::241 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 121)) with labels hypertext point pointtype 9 pointsize 0.4 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 9 pointsize 0.4 linecolor rgb "#56b4e9" title "custom-simple", \
     csv skip 1 every ::242::362 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::242::362 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 242)) with labels hypertext point pointtype 5 pointsize 0.4 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.4 linecolor rgb "#e69f00" title "box2d", \
     csv skip 1 every ::363::483 using (at_x($2)):(at_y($3)) with lines dashtype 4 linewidth 2 linecolor rgb "#009e73" notitle, \
     csv skip 1 every ::363::483 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 363)) with labels hypertext point pointtype 9 pointsize 0.4 linecolor rgb "#009e73" notitle, \
     NaN with linespoints dashtype 4 linewidth 2 pointtype 9 pointsize 0.4 linecolor rgb "#009e73" title "reference"
set terminal pngcairo size 1800,920 fontscale 1.9 linewidth 2 pointscale 2 font 'DejaVu Sans,11'
set output png
replot
unset output
if (!exists('page')) exit
set lmargin at screen 0.10357142857142858
set rmargin at screen 0.9785714285714285
set tmargin at screen 0.9692307692307692
set bmargin at screen 0.09743589743589742
unset key
unset xlabel
unset ylabel
set terminal svg size 560,390 font 'sans-serif,17' name "energy_box"
set output page
replot
unset output

# Run in this folder by: gnuplot -d toy-pairs.gp
csv = "../data/figure-toy-pairs.csv"
if (!exists('svg')) svg = "toy-pairs.svg"
if (!exists('png')) png = "toy-pairs.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set xrange [-0.8:40.8]
at_x(v) = v < -0.7999584000000001 ? -0.7999584000000001 : v > 40.799958399999994 ? 40.799958399999994 : v
set format y '%g'
set yrange [-10:510]
at_y(v) = v < -9.99948 ? -9.99948 : v > 509.99948 ? 509.99948 : v
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "balls n" noenhanced textcolor rgb ink
set ylabel "box tests per search" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "toy_pairs"
set output svg
plot csv skip 1 every ::0::30 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#808080" notitle, \
     csv skip 1 every ::0::30 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 4 pointsize 0.7 linecolor rgb "#808080" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 4 pointsize 0.7 linecolor rgb "#808080" title "brute force", \
     csv skip 1 every ::31::61 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#0072b2" notitle, \
     csv skip 1 every ::31::61 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 31)) with labels hypertext point pointtype 7 pointsize 0.7 linecolor rgb "#0072b2" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb "#0072b2" title "quadtree", \
     csv skip 1 every ::62::92 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#cc79a7" notitle, \
     csv skip 1 every ::62::92 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 62)) with labels hypertext point pointtype 9 pointsize 0.7 linecolor rgb "#cc79a7" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 9 pointsize 0.7 linecolor rgb "#cc79a7" title "adaptive quadtree", \
     csv skip 1 every ::93::123 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#999933" notitle, \
     csv skip 1 every ::93::123 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 93)) with labels hypertext point pointtype 5 pointsize 0.7 linecolor rgb "#999933" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.7 linecolor rgb "#999933" title "grid", \
     csv skip 1 every ::124::154 using (at_x($2)):(at_y($3)) with lines dashtype 4 linewidth 2 linecolor rgb "#882255" notitle, \
     csv skip 1 every ::124::154 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 124)) with labels hypertext point pointtype 13 pointsize 0.7 linecolor rgb "#882255" notitle, \
     NaN with linespoints dashtype 4 linewidth 2 pointtype 13 pointsize 0.7 linecolor rgb "#882255" title "sweep and prune", \
     csv skip 1 every ::155::156 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#0072b2" notitle, \
     csv skip 1 every ::155::156 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 155)) with labels hypertext point pointtype 7 pointsize 0.3 linecolor rgb "#0072b2" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 7 pointsize 0.3 linecolor rgb "#0072b2" title "quadtree: 1.324 n", \
     csv skip 1 every ::157::158 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#cc79a7" notitle, \
     csv skip 1 every ::157::158 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 157)) with labels hypertext point pointtype 7 pointsize 0.3 linecolor rgb "#cc79a7" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 7 pointsize 0.3 linecolor rgb "#cc79a7" title "adaptive quadtree: 5.477 n", \
     csv skip 1 every ::159::160 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#999933" notitle, \
     csv skip 1 every ::159::160 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 159)) with labels hypertext point pointtype 7 pointsize 0.3 linecolor rgb "#999933" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 7 pointsize 0.3 linecolor rgb "#999933" title "grid: 1.324 n", \
     csv skip 1 every ::161::162 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#882255" notitle, \
     csv skip 1 every ::161::162 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 161)) with labels hypertext point pointtype 7 pointsize 0.3 linecolor rgb "#882255" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 7 pointsize 0.3 linecolor rgb "#882255" title "sweep and prune: 3.499 n"
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
set terminal svg size 560,390 font 'sans-serif,17' name "toy_pairs"
set output page
replot
unset output

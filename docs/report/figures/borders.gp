# Run in this folder by: gnuplot -d borders.gp
csv = "../data/figure-borders.csv"
if (!exists('svg')) svg = "borders.svg"
if (!exists('png')) png = "borders.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set logscale x
set xtics ('10^{0}' 1e0, '' 2e0 1, '' 3e0 1, '' 4e0 1, '' 5e0 1, '' 6e0 1, '' 7e0 1, '' 8e0 1, '' 9e0 1, '10^{1}' 1e1, '' 2e1 1, '' 3e1 1, '' 4e1 1, '' 5e1 1, '' 6e1 1, '' 7e1 1, '' 8e1 1, '' 9e1 1, '10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10^{5}' 1e5, '' 2e5 1, '' 3e5 1, '' 4e5 1, '' 5e5 1, '' 6e5 1, '' 7e5 1, '' 8e5 1, '' 9e5 1, '10^{6}' 1e6)
set xrange [0.7585775750291838:1318256.7385564074]
at_x(v) = v < 0.7585884744494424 ? 0.7585884744494424 : v > 1318237.797806994 ? 1318237.797806994 : v
set format y '%g'
set ytics ("step, ms" 1, "at a ball, radii a step" 2, "at a wall, radii a step" 3, "stack, balls" 4, "mass ratio, hunted" 5, "mass ratio, from two sides" 6, "mass ratio, in a corner" 7, "mass ratio, thrown" 8, "mass ratio, lying" 9) noenhanced
set yrange [0.4:9.6]
at_y(v) = v < 0.4000092 ? 0.4000092 : v > 9.5999908 ? 9.5999908 : v
set lmargin at screen 0.21888888888888888
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9428571428571428
set bmargin at screen 0.19999999999999996
set key at screen 0.6722222222222223, screen 0.9428571428571428 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "the largest that holds" noenhanced textcolor rgb ink
set ylabel "experiment" noenhanced textcolor rgb ink
set terminal svg size 900,350 font 'sans-serif,14' name "borders"
set output svg
plot csv skip 1 every ::0::8 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 7 pointsize 1 linecolor rgb "#56b4e9" notitle, \
     NaN with points pointtype 7 pointsize 1 linecolor rgb "#56b4e9" title "custom-continuous", \
     csv skip 1 every ::9::17 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 9)) with labels hypertext point pointtype 9 pointsize 1 linecolor rgb "#56b4e9" notitle, \
     NaN with points pointtype 9 pointsize 1 linecolor rgb "#56b4e9" title "custom-simple", \
     csv skip 1 every ::18::26 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 18)) with labels hypertext point pointtype 5 pointsize 1 linecolor rgb "#e69f00" notitle, \
     NaN with points pointtype 5 pointsize 1 linecolor rgb "#e69f00" title "box2d", \
     csv skip 1 every ::27::35 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 27)) with labels hypertext point pointtype 9 pointsize 1 linecolor rgb "#009e73" notitle, \
     NaN with points pointtype 9 pointsize 1 linecolor rgb "#009e73" title "reference"
set terminal pngcairo size 1800,700 fontscale 1.9 linewidth 2 pointscale 2 font 'DejaVu Sans,11'
set output png
replot
unset output
if (!exists('page')) exit
set lmargin at screen 0.42607142857142855
set rmargin at screen 0.9785714285714285
set tmargin at screen 0.9612903225806452
set bmargin at screen 0.1225806451612903
unset key
unset xlabel
unset ylabel
set terminal svg size 560,310 font 'sans-serif,17' name "borders"
set output page
replot
unset output

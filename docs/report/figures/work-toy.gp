# Run in this folder by: gnuplot -d work-toy.gp
csv = "../data/figure-work-toy.csv"
if (!exists('svg')) svg = "work-toy.svg"
if (!exists('png')) png = "work-toy.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set logscale x
set xtics ('10^{-4}' 1e-4, '' 2e-4 1, '' 3e-4 1, '' 4e-4 1, '' 5e-4 1, '' 6e-4 1, '' 7e-4 1, '' 8e-4 1, '' 9e-4 1, '10^{-3}' 1e-3, '' 2e-3 1, '' 3e-3 1, '' 4e-3 1, '' 5e-3 1, '' 6e-3 1, '' 7e-3 1, '' 8e-3 1, '' 9e-3 1, '10^{-2}' 1e-2, '' 2e-2 1, '' 3e-2 1, '' 4e-2 1, '' 5e-2 1, '' 6e-2 1, '' 7e-2 1, '' 8e-2 1, '' 9e-2 1, '10^{-1}' 1e-1)
set xrange [8.709635899560814e-05:0.1148153621496883]
at_x(v) = v < 8.709698470380268e-05 ? 8.709698470380268e-05 : v > 0.11481453731157018 ? 0.11481453731157018 : v
set format y '%g'
set logscale y
set ytics ('10^{-14}' 1e-14, '' 1e-13 1, '10^{-12}' 1e-12, '' 1e-11 1, '10^{-10}' 1e-10, '' 1e-9 1, '10^{-8}' 1e-8, '' 1e-7 1, '10^{-6}' 1e-6, '' 1e-5 1, '10^{-4}' 1e-4, '' 1e-3 1, '10^{-2}' 1e-2, '' 1e-1 1, '10^{0}' 1e0, '' 1e1 1)
set yrange [5.0118723362727146e-15:19.952623149688797]
at_y(v) = v < 5.012052367601547e-15 ? 5.012052367601547e-15 : v > 19.95190645780374 ? 19.95190645780374 : v
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "CPU seconds per simulated second (box2d is Box2D 2.4.1)" noenhanced textcolor rgb ink
set ylabel "median error at the end of a window, radii" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "work_toy"
set output svg
plot csv skip 1 every ::0::8 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::0::8 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" title "box2d", \
     csv skip 1 every ::9::14 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::9::14 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 9)) with labels hypertext point pointtype 4 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 4 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-20-10", \
     csv skip 1 every ::15::20 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::15::20 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 15)) with labels hypertext point pointtype 11 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 11 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-fine-arcs", \
     csv skip 1 every ::21::26 using (at_x($2)):(at_y($3)) with lines dashtype 4 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::21::26 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 21)) with labels hypertext point pointtype 10 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 4 linewidth 2 pointtype 10 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-no-bullets", \
     csv skip 1 every ::27::32 using (at_x($2)):(at_y($3)) with lines dashtype 5 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::27::32 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 27)) with labels hypertext point pointtype 13 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 5 linewidth 2 pointtype 13 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-substeps-4", \
     csv skip 1 every ::33::37 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::33::37 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 33)) with labels hypertext point pointtype 12 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 12 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-tuned", \
     csv skip 1 every ::38::43 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::38::43 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 38)) with labels hypertext point pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-verlet", \
     csv skip 1 every ::44::52 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::44::52 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 44)) with labels hypertext point pointtype 7 pointsize 0.8 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.8 linecolor rgb "#56b4e9" title "custom-continuous", \
     csv skip 1 every ::53::61 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::53::61 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 53)) with labels hypertext point pointtype 6 pointsize 0.8 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 6 pointsize 0.8 linecolor rgb "#56b4e9" title "custom-simple", \
     csv skip 1 every ::62::67 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::62::67 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 62)) with labels hypertext point pointtype 9 pointsize 0.8 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 9 pointsize 0.8 linecolor rgb "#56b4e9" title "custom-simple-tuned", \
     csv skip 1 every ::68::68 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#009e73" notitle, \
     csv skip 1 every ::68::68 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 68)) with labels hypertext point pointtype 7 pointsize 0.8 linecolor rgb "#009e73" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.8 linecolor rgb "#009e73" title "reference-53"
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
set terminal svg size 560,390 font 'sans-serif,17' name "work_toy"
set output page
replot
unset output

# Run in this folder by: gnuplot -d divergence.gp
csv = "../data/figure-divergence.csv"
if (!exists('svg')) svg = "divergence.svg"
if (!exists('png')) png = "divergence.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set xrange [-0.2:10.2]
at_x(v) = v < -0.19998960000000002 ? -0.19998960000000002 : v > 10.199989599999999 ? 10.199989599999999 : v
set format y '%g'
set logscale y
set ytics ('10^{-15}' 1e-15, '' 1e-14 1, '' 1e-13 1, '10^{-12}' 1e-12, '' 1e-11 1, '' 1e-10 1, '10^{-9}' 1e-9, '' 1e-8 1, '' 1e-7 1, '10^{-6}' 1e-6, '' 1e-5 1, '' 1e-4 1, '10^{-3}' 1e-3, '' 1e-2 1, '' 1e-1 1, '10^{0}' 1e0, '' 1e1 1, '' 1e2 1)
set yrange [4.570881896148752e-16:218.77616239495518]
at_y(v) = v < 4.571067979187459e-16 ? 4.571067979187459e-16 : v > 218.7672562633289 ? 218.7672562633289 : v
set object rectangle from 2.0166666666666666, graph 0 to graph 1, graph 1 behind fillcolor rgb "#808080" fillstyle solid 0.15 noborder
set arrow from 2.0166666666666666, graph 0 to 2.0166666666666666, graph 1 nohead dashtype 3 linewidth 2 linecolor rgb "#808080"
set label "past the horizon" at 2.0166666666666666, graph 0.61 rotate by -90 offset 1.2,0 center noenhanced font ',11' textcolor rgb "#808080"
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "time, s" noenhanced textcolor rgb ink
set ylabel "largest distance between the two, radii" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "divergence"
set output svg
plot csv skip 1 every ::0::118 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::0::118 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 5 pointsize 0.35 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.35 linecolor rgb "#e69f00" title "box2d and reference", \
     csv skip 1 every ::119::277 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::119::277 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 119)) with labels hypertext point pointtype 9 pointsize 0.35 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 9 pointsize 0.35 linecolor rgb "#56b4e9" title "custom-simple and reference", \
     csv skip 1 every ::278::412 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::278::412 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 278)) with labels hypertext point pointtype 7 pointsize 0.35 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.35 linecolor rgb "#56b4e9" title "custom-continuous and reference", \
     csv skip 1 every ::413::563 using (at_x($2)):(at_y($3)) with lines dashtype 3 linewidth 2 linecolor rgb "#cc79a7" notitle, \
     csv skip 1 every ::413::563 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 413)) with labels hypertext point pointtype 12 pointsize 0.35 linecolor rgb "#cc79a7" notitle, \
     NaN with linespoints dashtype 3 linewidth 2 pointtype 12 pointsize 0.35 linecolor rgb "#cc79a7" title "custom-simple and box2d", \
     csv skip 1 every ::564::682 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#cc79a7" notitle, \
     csv skip 1 every ::564::682 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 564)) with labels hypertext point pointtype 13 pointsize 0.35 linecolor rgb "#cc79a7" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 13 pointsize 0.35 linecolor rgb "#cc79a7" title "custom-continuous and box2d"
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
set terminal svg size 560,390 font 'sans-serif,17' name "divergence"
set output page
replot
unset output

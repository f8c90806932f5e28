# Run in this folder by: gnuplot -d pairs-growth.gp
csv = "../data/figure-pairs-growth.csv"
if (!exists('svg')) svg = "pairs-growth.svg"
if (!exists('png')) png = "pairs-growth.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set logscale x
set xtics ('10^{1}' 1e1, '' 2e1 1, '' 3e1 1, '' 4e1 1, '' 5e1 1, '' 6e1 1, '' 7e1 1, '' 8e1 1, '' 9e1 1, '10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10^{5}' 1e5)
set xrange [8.31763771102671:120226.4434617413]
at_x(v) = v < 8.31771738401368 ? 8.31771738401368 : v > 120225.2918477322 ? 120225.2918477322 : v
set format y '%g'
set logscale y
set ytics ('10^{0}' 1e0, '' 2e0 1, '' 3e0 1, '' 4e0 1, '' 5e0 1, '' 6e0 1, '' 7e0 1, '' 8e0 1, '' 9e0 1, '10^{1}' 1e1, '' 2e1 1, '' 3e1 1, '' 4e1 1, '' 5e1 1, '' 6e1 1, '' 7e1 1, '' 8e1 1, '' 9e1 1, '10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4)
set yrange [0.831763771102671:12022.644346174131]
at_y(v) = v < 0.8317717384013679 ? 0.8317717384013679 : v > 12022.529184773219 ? 12022.529184773219 : v
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "balls n" noenhanced textcolor rgb ink
set ylabel "box tests per ball and search" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "pairs_growth"
set output svg
plot csv skip 1 every ::0::4 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#808080" notitle, \
     csv skip 1 every ::0::4 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 4 pointsize 0.7 linecolor rgb "#808080" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 4 pointsize 0.7 linecolor rgb "#808080" title "brute force", \
     csv skip 1 every ::5::12 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#0072b2" notitle, \
     csv skip 1 every ::5::12 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 5)) with labels hypertext point pointtype 7 pointsize 0.7 linecolor rgb "#0072b2" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb "#0072b2" title "quadtree", \
     csv skip 1 every ::13::20 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#cc79a7" notitle, \
     csv skip 1 every ::13::20 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 13)) with labels hypertext point pointtype 9 pointsize 0.7 linecolor rgb "#cc79a7" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 9 pointsize 0.7 linecolor rgb "#cc79a7" title "adaptive quadtree", \
     csv skip 1 every ::21::28 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#999933" notitle, \
     csv skip 1 every ::21::28 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 21)) with labels hypertext point pointtype 5 pointsize 0.7 linecolor rgb "#999933" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.7 linecolor rgb "#999933" title "grid", \
     csv skip 1 every ::29::36 using (at_x($2)):(at_y($3)) with lines dashtype 4 linewidth 2 linecolor rgb "#882255" notitle, \
     csv skip 1 every ::29::36 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 29)) with labels hypertext point pointtype 13 pointsize 0.7 linecolor rgb "#882255" notitle, \
     NaN with linespoints dashtype 4 linewidth 2 pointtype 13 pointsize 0.7 linecolor rgb "#882255" title "sweep and prune"
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
set terminal svg size 560,390 font 'sans-serif,17' name "pairs_growth"
set output page
replot
unset output

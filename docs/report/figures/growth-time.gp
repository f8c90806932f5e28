# Run in this folder by: gnuplot -d growth-time.gp
csv = "../data/figure-growth-time.csv"
if (!exists('svg')) svg = "growth-time.svg"
if (!exists('png')) png = "growth-time.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set logscale x
set xtics ('10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10^{5}' 1e5)
set xrange [87.09635899560806:114815.36214968817]
at_x(v) = v < 87.0969847038026 ? 87.0969847038026 : v > 114814.53731157005 ? 114814.53731157005 : v
set format y '%g'
set logscale y
set ytics ('10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10^{5}' 1e5)
set yrange [87.09635899560806:114815.36214968817]
at_y(v) = v < 87.0969847038026 ? 87.0969847038026 : v > 114814.53731157005 ? 114814.53731157005 : v
set lmargin at screen 0.1
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9565217391304348
set bmargin at screen 0.15217391304347827
set key at screen 0.6722222222222223, screen 0.9565217391304348 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "balls" noenhanced textcolor rgb ink
set ylabel "CPU time per ball and step, ns (box2d is Box2D 2.4.1)" noenhanced textcolor rgb ink
set terminal svg size 900,460 font 'sans-serif,14' name "growth_time"
set output svg
plot csv skip 1 every ::0::6 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#56b4e9" notitle, \
     csv skip 1 every ::0::6 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 7 pointsize 0.8 linecolor rgb "#56b4e9" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 7 pointsize 0.8 linecolor rgb "#56b4e9" title "custom", \
     csv skip 1 every ::7::11 using (at_x($2)):(at_y($3)) with lines dashtype 1 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::7::11 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 7)) with labels hypertext point pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::12::13 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 12)) with labels hypertext point pointtype 2 pointsize 1.2 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 1 linewidth 2 pointtype 5 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-bullets", \
     csv skip 1 every ::14::18 using (at_x($2)):(at_y($3)) with lines dashtype 2 linewidth 2 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::14::18 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 14)) with labels hypertext point pointtype 4 pointsize 0.8 linecolor rgb "#e69f00" notitle, \
     csv skip 1 every ::19::20 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 19)) with labels hypertext point pointtype 2 pointsize 1.2 linecolor rgb "#e69f00" notitle, \
     NaN with linespoints dashtype 2 linewidth 2 pointtype 4 pointsize 0.8 linecolor rgb "#e69f00" title "box2d-no-bullets"
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
set terminal svg size 560,390 font 'sans-serif,17' name "growth_time"
set output page
replot
unset output

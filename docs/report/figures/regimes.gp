# Run in this folder by: gnuplot -d regimes.gp
csv = "../data/figure-regimes.csv"
if (!exists('svg')) svg = "regimes.svg"
if (!exists('png')) png = "regimes.png"
ink = "#010101"
set encoding utf8
set datafile separator comma
set datafile commentschars ''
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1
set format x '%g'
set logscale x
set xtics ('10^{-2}' 1e-2, '' 2e-2 1, '' 3e-2 1, '' 4e-2 1, '' 5e-2 1, '' 6e-2 1, '' 7e-2 1, '' 8e-2 1, '' 9e-2 1, '10^{-1}' 1e-1, '' 2e-1 1, '' 3e-1 1, '' 4e-1 1, '' 5e-1 1, '' 6e-1 1, '' 7e-1 1, '' 8e-1 1, '' 9e-1 1, '10^{0}' 1e0, '' 2e0 1, '' 3e0 1, '' 4e0 1, '' 5e0 1, '' 6e0 1, '' 7e0 1, '' 8e0 1, '' 9e0 1, '10^{1}' 1e1, '' 2e1 1, '' 3e1 1, '' 4e1 1, '' 5e1 1, '' 6e1 1, '' 7e1 1, '' 8e1 1, '' 9e1 1, '10^{2}' 1e2, '' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10^{3}' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10^{4}' 1e4)
set xrange [0.007585775750291836:13182.567385564074]
at_x(v) = v < 0.007585884744494423 ? 0.007585884744494423 : v > 13182.37797806994 ? 13182.37797806994 : v
set format y '%g'
set ytics ("toy, 100" 1, "toy, 1" 2, "pinball, 8" 3, "pinball, 1" 4, "asleep, 1000" 5, "rain, heaped, 1000" 6, "rain, raining, 1000" 7, "rain, falling, 1000" 8, "asleep, 320" 9, "rain, coming to rest, 320" 10, "rain, heaped, 320" 11, "rain, raining, 320" 12, "rain, falling, 320" 13, "gas, 500" 14) noenhanced
set yrange [0.4:14.6]
at_y(v) = v < 0.40001420000000004 ? 0.40001420000000004 : v > 14.599985799999999 ? 14.599985799999999 : v
set lmargin at screen 0.2111111111111111
set rmargin at screen 0.6555555555555556
set tmargin at screen 0.9583333333333334
set bmargin at screen 0.14583333333333337
set key at screen 0.6722222222222223, screen 0.9583333333333334 left top Left reverse samplen 2.5 noenhanced textcolor rgb ink
set xlabel "CPU time per ball and step, ns" noenhanced textcolor rgb ink
set ylabel "regime" noenhanced textcolor rgb ink
set terminal svg size 900,480 font 'sans-serif,14' name "regimes"
set output svg
plot csv skip 1 every ::0::9 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 0)) with labels hypertext point pointtype 5 pointsize 1 linecolor rgb "#808080" notitle, \
     NaN with points pointtype 5 pointsize 1 linecolor rgb "#808080" title "bare-loop", \
     csv skip 1 every ::10::23 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 10)) with labels hypertext point pointtype 7 pointsize 1 linecolor rgb "#56b4e9" notitle, \
     NaN with points pointtype 7 pointsize 1 linecolor rgb "#56b4e9" title "custom-continuous", \
     csv skip 1 every ::24::37 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 24)) with labels hypertext point pointtype 6 pointsize 1 linecolor rgb "#56b4e9" notitle, \
     NaN with points pointtype 6 pointsize 1 linecolor rgb "#56b4e9" title "custom-continuous-unread", \
     csv skip 1 every ::38::51 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 38)) with labels hypertext point pointtype 9 pointsize 1 linecolor rgb "#56b4e9" notitle, \
     NaN with points pointtype 9 pointsize 1 linecolor rgb "#56b4e9" title "custom-simple", \
     csv skip 1 every ::52::65 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 52)) with labels hypertext point pointtype 5 pointsize 1 linecolor rgb "#e69f00" notitle, \
     NaN with points pointtype 5 pointsize 1 linecolor rgb "#e69f00" title "box2d", \
     csv skip 1 every ::66::79 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 66)) with labels hypertext point pointtype 4 pointsize 1 linecolor rgb "#e69f00" notitle, \
     NaN with points pointtype 4 pointsize 1 linecolor rgb "#e69f00" title "box2d-no-bullets", \
     csv skip 1 every ::80::93 using (at_x($2)):(at_y($3)):(sprintf('%d', $0 + 80)) with labels hypertext point pointtype 11 pointsize 1 linecolor rgb "#e69f00" notitle, \
     NaN with points pointtype 11 pointsize 1 linecolor rgb "#e69f00" title "box2d-not-continuous"
set terminal pngcairo size 1800,960 fontscale 1.9 linewidth 2 pointscale 2 font 'DejaVu Sans,11'
set output png
replot
unset output
if (!exists('page')) exit
set lmargin at screen 0.4107142857142857
set rmargin at screen 0.9785714285714285
set tmargin at screen 0.9727272727272728
set bmargin at screen 0.08636363636363631
unset key
unset xlabel
unset ylabel
set terminal svg size 560,440 font 'sans-serif,17' name "regimes"
set output page
replot
unset output

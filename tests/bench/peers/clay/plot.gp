# gnuplot -e "data='FILE'" plot.gp: a tick of each model against its rows, as SVG.
set terminal svg size 760,620 font 'sans-serif,13' background 'white'
set logscale xy
set xrange [180:2300]
set yrange [0.05:2e6]
set xtics (200, 400, 800, 2000)
set ytics ('0.1 us' 0.1, '1 us' 1, '10 us' 10, '100 us' 100, '1 ms' 1e3, '10 ms' 1e4, '100 ms' 1e5, '1 s' 1e6)
set xlabel 'rows along a profile of 200 mm'
set ylabel 'one tick'
set key below maxcols 2
set grid
set arrow from 180,1000 to 2300,1000 nohead dashtype 2 linewidth 2
plot for [k=0:7] data index k using 1:2 with linespoints linewidth 2 title columnheader(1)

# Written by mrppsim. `gnuplot -d small_benchmark-time.gp`, run in this file's folder, draws it again.
reset
set encoding utf8
file_name = 'small_benchmark-time'
title_text = 'Time, small benchmark problems'
measure_text = 'Time (ms)'
label_0 = 'push_and_swap (8/8 solved)'
label_1 = 'fails often (8/8 solved)'
row_0 = 'tree'
row_1 = 'grid 100%%'
$values_0 << e
-0.2 5.635 4 4
0.8 9.315 4 4
e
$success_0 << e
-0.2 100
0.8 100
e
$values_1 << e
0.2 7.3255 4 4
1.2 12.1095 4 4
e
$success_1 << e
0.2 100
1.2 100
e
do for [format in 'png pdf svg'] {
if (format eq 'png') { set terminal pngcairo noenhanced size 1890,588 font 'DejaVu Sans,9' fontscale 3.1250 linewidth 4.1667 pointscale 4.1667 }
if (format eq 'pdf') { set terminal pdfcairo noenhanced size 16.00cm,4.98cm font 'DejaVu Sans,9' fontscale 0.75 }
if (format eq 'svg') { set terminal svg noenhanced size 605,188 font 'DejaVu Sans,12' background '#ffffff' }
title_font = 'DejaVu Sans Bold,'.(format eq 'svg' ? '13.3' : '10')
small_font = 'DejaVu Sans,'.(format eq 'svg' ? '10.6' : '8')
set output file_name.'.'.format
set multiplot
set tics nomirror out scale 0.6,0.3
set border 3 lc rgb '#404040'
set grid xtics ytics lc rgb '#d9d9d9' lw 0.5 dt solid
set object 1 rectangle from graph 0, first 0.5 to graph 1, first 1.5 behind fc rgb '#f0f0f0' fs solid noborder
set lmargin at screen 0.15344
set rmargin at screen 0.78125
set bmargin at screen 0.40763
set tmargin at screen 0.80924
unset logscale x
set xrange [0:12.83607]
set xtics ('0' 0, '2' 2, '4' 4, '6' 6, '8' 8, '10' 10, '12' 12)
set yrange [1.5:-0.5]
set ytics (row_0 0, row_1 1) scale 0
set grid noytics
set xlabel measure_text noenhanced
set title title_text noenhanced font title_font offset 0,-0.2
set key at screen 0.04,0.03012 left bottom vertical Left reverse noenhanced samplen 3 spacing 1.1 width -1 maxrows 1
plot $values_0 using ($3==$4?$2:NaN):1 with points pt 7 ps 0.7 lc rgb '#0072b2' notitle, \
     $values_0 using ($3<$4?$2:NaN):1 with points pt 7 ps 0.7 lc rgb '#ffffff' notitle, \
     $values_0 using ($3<$4?$2:NaN):1 with points pt 6 ps 0.7 lc rgb '#0072b2' notitle, \
     keyentry with points pt 7 ps 0.7 lc rgb '#0072b2' title label_0, \
     $values_1 using ($3==$4?$2:NaN):1 with points pt 5 ps 0.7 lc rgb '#d55e00' notitle, \
     $values_1 using ($3<$4?$2:NaN):1 with points pt 5 ps 0.7 lc rgb '#ffffff' notitle, \
     $values_1 using ($3<$4?$2:NaN):1 with points pt 4 ps 0.7 lc rgb '#d55e00' notitle, \
     keyentry with points pt 5 ps 0.7 lc rgb '#d55e00' title label_1
set lmargin at screen 0.80625
set rmargin at screen 0.96250
set bmargin at screen 0.40763
set tmargin at screen 0.80924
unset logscale x
set xrange [-12:112]
set xtics ('0' 0, '50' 50, '100' 100)
set format y ''
set ytics () scale 0
set xlabel 'Solved (%)' noenhanced
unset title
unset key
plot $success_0 using 2:1 with points pt 7 ps 0.55 lc rgb '#0072b2', \
     $success_1 using 2:1 with points pt 5 ps 0.55 lc rgb '#d55e00'
unset multiplot
reset
}
set output

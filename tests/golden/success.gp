# Written by mrppsim. `gnuplot -d fg_vr-grid-success_rate.gp`, run in this file's folder, draws it again.
reset
set encoding utf8
file_name = 'fg_vr-grid-success_rate'
title_text = 'Success rate on grid'
measure_text = 'Instances solved (%)'
label_0 = 'push_and_swap (16/16 solved)'
label_1 = 'fails often (9/16 solved)'
variable_text = 'Robots'
share_text = 'Solved (%)'
$values_0 << e
1 100 4 4
2 100 4 4
3 100 4 4
4 100 4 4
e
$values_1 << e
1 100 4 4
2 0 0 4
3 25 1 4
4 100 4 4
e
do for [format in 'png pdf svg'] {
if (format eq 'png') { set terminal pngcairo noenhanced size 1890,1131 font 'DejaVu Sans,9' fontscale 3.1250 linewidth 4.1667 pointscale 4.1667 }
if (format eq 'pdf') { set terminal pdfcairo noenhanced size 16.00cm,9.58cm font 'DejaVu Sans,9' fontscale 0.75 }
if (format eq 'svg') { set terminal svg noenhanced size 605,362 font 'DejaVu Sans,12' background '#ffffff' }
title_font = 'DejaVu Sans Bold,'.(format eq 'svg' ? '13.3' : '10')
small_font = 'DejaVu Sans,'.(format eq 'svg' ? '10.6' : '8')
set output file_name.'.'.format
set multiplot
set tics nomirror out scale 0.6,0.3
set border 3 lc rgb '#404040'
set grid xtics ytics lc rgb '#d9d9d9' lw 0.5 dt solid
set lmargin at screen 0.15000
set rmargin at screen 0.96250
set bmargin at screen 0.21190
set tmargin at screen 0.90084
unset logscale x
set xrange [0.91:4.09]
set xtics ('1' 1, '2' 2, '3' 3, '4' 4)
unset logscale y
set yrange [-4:104]
set ytics ('0' 0, '25' 25, '50' 50, '75' 75, '100' 100)
set label 1 measure_text at screen 0.03438,0.55637 center rotate noenhanced
set title title_text noenhanced font title_font offset 0,-0.2
set xlabel variable_text noenhanced
set key at screen 0.04,0.01566 left bottom vertical Left reverse noenhanced samplen 3 spacing 1.1 width -1 maxrows 1
plot $values_0 using 1:2 with lines lw 1.5 dt solid lc rgb '#0072b2' notitle, \
     $values_0 using 1:($3==$4?$2:NaN) with points pt 7 ps 0.7 lc rgb '#0072b2' notitle, \
     $values_0 using 1:($3<$4?$2:NaN) with points pt 7 ps 0.7 lc rgb '#ffffff' notitle, \
     $values_0 using 1:($3<$4?$2:NaN) with points pt 6 ps 0.7 lc rgb '#0072b2' notitle, \
     keyentry with linespoints pt 7 ps 0.7 lw 1.5 dt solid lc rgb '#0072b2' title label_0, \
     $values_1 using 1:2 with lines lw 1.5 dt (12,5) lc rgb '#d55e00' notitle, \
     $values_1 using 1:($3==$4?$2:NaN) with points pt 5 ps 0.7 lc rgb '#d55e00' notitle, \
     $values_1 using 1:($3<$4?$2:NaN) with points pt 5 ps 0.7 lc rgb '#ffffff' notitle, \
     $values_1 using 1:($3<$4?$2:NaN) with points pt 4 ps 0.7 lc rgb '#d55e00' notitle, \
     keyentry with linespoints pt 5 ps 0.7 lw 1.5 dt (12,5) lc rgb '#d55e00' title label_1
unset multiplot
reset
}
set output

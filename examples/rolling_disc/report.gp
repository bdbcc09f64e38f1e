# Draws the pictures of the rolling disc from the tables in the directory `dir`: gnuplot -e "dir='...'" report.gp
set encoding utf8
set terminal svg size 920,560 dynamic enhanced font 'Helvetica,15' background '#ffffff' linewidth 1.7
blue = '#0072b2'; orange = '#d55e00'; green = '#009e73'; pink = '#cc79a7'; grey = '#777777'; sky = '#56b4e9'
set border 3 lc rgb '#444444'
set tics nomirror out textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lt 1 lw 0.7
set key above horizontal center samplen 2 spacing 1.1
set xlabel 't [s]'
data(name) = dir . '/' . name . '.dat'

# --- the solution -----------------------------------------------------------------------------------------
set output dir . '/solution.svg'
set key at graph 0.5,1.10 center horizontal maxrows 1
set multiplot layout 2,2 margins 0.115,0.985,0.11,0.93 spacing 0.125,0.14
unset xlabel
set format x ''
set ylabel 'contact point [m]'
plot data('solution') using 1:2 with lines lc rgb blue title 'x', '' using 1:3 with lines lc rgb orange title 'y'
set ylabel 'angles [rad]'
plot data('solution') using 1:4 with lines lc rgb blue title 'heading α', '' using 1:6 with lines lc rgb green title 'rolling γ'
set format x '%g'
set xlabel 't [s]'
set ylabel 'leaning β [rad]'
plot data('solution') using 1:5 with lines lc rgb pink notitle
set ylabel 'constraint force λ [N]'
plot data('solution') using 1:12 with lines lc rgb blue title 'λ_1', '' using 1:13 with lines lc rgb orange title 'λ_2'
unset multiplot

# --- the track on the plane -------------------------------------------------------------------------------
set output dir . '/track.svg'
set key above horizontal center maxrows 1
set size ratio -1
set label 1 'start' at -0.005,0.008 right
set xlabel 'x_{lab} [m]'; set ylabel 'y_{lab} [m]'
# The contact point is (x, y) turned by α; the centre lies R sin β further to the side.
lx(x,y,a) = cos(a)*x - sin(a)*y
ly(x,y,a) = sin(a)*x + cos(a)*y
plot data('solution') using (lx($2,$3,$4)):(ly($2,$3,$4)) with lines lc rgb blue title 'contact point', \
     '' using (lx($2,$3-0.1*sin($5),$4)):(ly($2,$3-0.1*sin($5),$4)) with lines lc rgb orange title 'centre, seen from above', \
     '' every 1000::0 using (lx($2,$3,$4)):(ly($2,$3,$4)) with points pt 7 ps 0.7 lc rgb blue notitle
set size noratio
unset label 1

# --- energy -----------------------------------------------------------------------------------------------
set output dir . '/energy.svg'
set key at graph 0.5,1.10 center horizontal maxrows 1
set multiplot layout 2,1 margins 0.12,0.985,0.11,0.93 spacing 0.10,0.16
unset xlabel
set format x ''
set ylabel 'energy [J]'
set yrange [0:*]
plot data('solution') using 1:16 with lines lc rgb 'black' title 'total', \
     '' using 1:14 with lines lc rgb blue title 'kinetic', '' using 1:15 with lines lc rgb orange title 'potential'
set format x '%g'
set xlabel 't [s]'
set autoscale y
set logscale y
set format y '10^{%T}'
set ylabel '|energy − energy at 0| [J]'
# What is exactly zero has no logarithm and is left out. At tolerance 10^{-12} only rounding errors are left, from step
# to step anew: points, as lines between them would fill the picture.
shown(x) = x > 0 ? x : NaN
plot data('steps_4') using 1:(shown(abs($5))) with lines lc rgb orange title 'tol 10^{-4}', \
     data('steps_8') using 1:(shown(abs($5))) with lines lc rgb green title 'tol 10^{-8}', \
     data('steps_12') using 1:(shown(abs($5))) with points pt 7 ps 0.2 lc rgb blue title 'tol 10^{-12}'
unset multiplot

# --- constraint violation ---------------------------------------------------------------------------------
set output dir . '/violation.svg'
set ylabel "|G(q) q'| [m/s] at accepted steps"
larger(a,b) = shown(abs(a) > abs(b) ? abs(a) : abs(b))
set yrange [1e-17:1e-7]
set key above horizontal center maxrows 2 width -4
plot data('reduced_8') using 1:(larger($3,$4)) with lines lc rgb orange title 'index-reduced ODE, tol 10^{-8}: drift', \
     data('steps_8') using 1:(larger($3,$4)) with lines lc rgb green title 'index-2 DAE, tol 10^{-8}', \
     data('reduced_12') using 1:(larger($3,$4)) with lines lc rgb pink title 'index-reduced ODE, tol 10^{-12}: drift', \
     data('steps_12') using 1:(larger($3,$4)) with points pt 7 ps 0.2 lc rgb blue title 'index-2 DAE, tol 10^{-12}: rounding'

# --- step sizes -------------------------------------------------------------------------------------------
set output dir . '/steps.svg'
set ylabel 'step size h [s]'
set autoscale y
set key maxrows 1 width 0
plot data('steps_4') using ($1-$2):2 with steps lc rgb orange title 'tol 10^{-4}', \
     data('steps_6') using ($1-$2):2 with steps lc rgb pink title 'tol 10^{-6}', \
     data('steps_8') using ($1-$2):2 with steps lc rgb green title 'tol 10^{-8}', \
     data('steps_10') using ($1-$2):2 with steps lc rgb sky title 'tol 10^{-10}', \
     data('steps_12') using ($1-$2):2 with steps lc rgb blue title 'tol 10^{-12}'

# --- error against run time -------------------------------------------------------------------------------
set output dir . '/work.svg'
set logscale x
set format x '%g'
set xlabel 'run time [µs], minimum of the repeats'
set ylabel 'maximum error at t = 1 s, in SI units'
set key maxrows 2
plot for [s in methods] data('work_' . s) using 8:6 with linespoints pt 7 ps 0.6 lc rgb (s eq '3' ? blue : s eq '5' ? green : pink) title "q, q': Radau IIA, s = " . s, \
     for [s in methods] data('work_' . s) using 8:7 with linespoints pt 6 ps 0.6 dt 2 lc rgb (s eq '3' ? blue : s eq '5' ? green : pink) title 'λ: Radau IIA, s = ' . s
set output

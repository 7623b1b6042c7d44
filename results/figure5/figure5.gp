# Fig. 5 of the paper in our numbers: gnuplot figure5.gp, beside speed/summary.csv and robots/summary.csv.
# With another rule book, in its folder: gnuplot -e "book='2014'" ../figure5.gp
set terminal svg size 900,380 font "Helvetica,13" background "white"
set output "figure5.svg"
set datafile separator ","
under = exists("book") && strlen(book) > 0 ? ", rules " . book : ""
stats "speed/summary.csv" using (column("games")) name "speed" nooutput
stats "robots/summary.csv" using (column("games")) name "robots" nooutput
set multiplot layout 1,2
set key left top reverse Left
set grid ytics
set yrange [0:*]
set offsets 0, 0, graph 0.04, 0  # room above the highest bar
# Bars end at 0, since no team has fewer goals.
low(mean, deviation) = mean > deviation ? mean - deviation : 0
set ylabel "goals a game, mean and standard deviation"
full = "#1f6fb4"
less = "#d1495b"

set title sprintf("acceleration and top speed scaled, %d games a value%s", speed_max, under)
set xlabel "share of full acceleration and top speed"
set xrange [1.05:0.45]
plot "speed/summary.csv" using ($1+0.006):4:(low($4,$5)):($4+$5) skip 1 with yerrorbars pt 7 lc rgb full title "unhandicapped", \
     "" using ($1+0.006):4 skip 1 with lines lc rgb full notitle, \
     "" using ($1-0.006):6:(low($6,$7)):($6+$7) skip 1 with yerrorbars pt 5 lc rgb less title "handicapped", \
     "" using ($1-0.006):6 skip 1 with lines lc rgb less notitle

set title sprintf("fewer robots, %d games a value%s", robots_max, under)
set xlabel "robots"
set xrange [6.5:0.5]
set xtics 1
plot "robots/summary.csv" using ($1+0.06):4:(low($4,$5)):($4+$5) skip 1 with yerrorbars pt 7 lc rgb full title "unhandicapped", \
     "" using ($1+0.06):4 skip 1 with lines lc rgb full notitle, \
     "" using ($1-0.06):6:(low($6,$7)):($6+$7) skip 1 with yerrorbars pt 5 lc rgb less title "handicapped", \
     "" using ($1-0.06):6 skip 1 with lines lc rgb less notitle
unset multiplot

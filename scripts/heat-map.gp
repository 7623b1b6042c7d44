# Heat maps of sweeps over two factors, both with the same number of equally spaced values. The panels of the
# summary.csv files are stacked in order. Each cell shows the mean of "a minus b" and its 95 % interval. Blue: team a is
# ahead; orange: team b.
#
#   gnuplot -c scripts/heat-map.gp OUT.svg "LABEL OF THE FIRST FACTOR" "LABEL OF THE SECOND" TITLE SUMMARY.csv ...
set datafile separator ","
panels = (ARGC - 3) / 2
title_of(panel) = value(sprintf("ARG%d", 2 * panel + 2))
file_of(panel) = value(sprintf("ARG%d", 2 * panel + 3))

# The colour range ends at the largest lead of all panels; without one, any number will do.
reach = 0
do for [panel=1:panels] {
  stats file_of(panel) using (abs(column("mean_diff"))) name "lead" nooutput
  reach = lead_max > reach ? lead_max : reach
}
if (reach == 0) { reach = 1 }

set terminal svg size 680, 540 * panels font "Helvetica,13" background "white"
set output ARG1
set multiplot layout panels,1
set palette defined (-1 '#f1a25f', 0 '#ffffff', 1 '#6fb1dc')
colour(lead) = sgn(lead) * sqrt(abs(lead))  # so that small leads can be distinguished
set cbrange [colour(-reach):colour(reach)]
unset colorbox
unset key
set border 0
set tics scale 0
set style fill solid 1.0 border rgb "white"
set xlabel ARG3
set ylabel ARG2
interval(row) = strlen(stringcolumn("diff_low95")) == 0 ? "" : \
                sprintf("[%+.1f, %+.1f]", column("diff_low95"), column("diff_high95"))
do for [panel=1:panels] {
  stats file_of(panel) using 1 name "down" nooutput
  stats file_of(panel) using 2 name "across" nooutput
  values = floor(sqrt(down_records) + 0.5)
  half_down = values > 1 ? (down_max - down_min) / (values - 1) / 2 : 0.5
  half_across = values > 1 ? (across_max - across_min) / (values - 1) / 2 : 0.5
  set yrange [down_min - half_down:down_max + half_down]
  set xrange [across_max + half_across:across_min - half_across]
  set ytics 2 * half_down
  set xtics 2 * half_across
  set title title_of(panel)
  plot file_of(panel) using 2:1:($2 - half_across):($2 + half_across):($1 - half_down):($1 + half_down):(colour(column("mean_diff"))) \
         with boxxyerror lc palette, \
       "" using 2:($1 + 0.3 * half_down):(sprintf("%+.2f", column("mean_diff"))) with labels font ",14", \
       "" using 2:($1 - 0.35 * half_down):(interval(0)) with labels font ",10"
}
unset multiplot

# SPDX-License-Identifier: MIT
# Draws what `bench_peers --csv` wrote, with all families and peers and both modes, as an SVG on standard output:
# milliseconds by family, searches from bare arrays on the left, updates on the right, each line named at its end.
#
#     gnuplot -e "rows='out/peers.csv'" bench/peers/chart.gp > docs/gallery/peers.svg
#
# Needs gnuplot 5.4 (Debian: gnuplot-nox).
if (!exists("rows")) rows = 'out/peers.csv'
families = "u05 u30 pile poly clus floor column"
kinds = "'5 %' '30 %' '60 %' '1 : 10' clouds plane tall"
peers = "embree nanoflann cgal fcl bullet bullet-deferred"
names = "Embree nanoflann CGAL FCL Bullet 'Bullet, deferred'"
colours = "#0B6FB5 #00795A #A8478A #8A6A00 #444444 #7D7D7D"
our_colour = "#D1490B"
face = "sans-serif"
set datafile separator comma

# The median of a column over the rows of a family, a peer ('' for all) and a mode.
wanted(family, peer, mode) = strcol(1) eq family && (peer eq '' || strcol(4) eq peer) && strcol(5) eq mode
array Time[2 * 7 * 7]  # mode, line (the last is ours), family
name(line) = line < 6 ? word(names, line + 1) : "Ballpit"
colour(line) = line < 6 ? word(colours, line + 1) : our_colour
place(m, line, f) = (m * 7 + line) * 7 + f + 1
do for [m = 0:1] {
  mode = word("cold update", m + 1)
  do for [line = 0:6] {
    peer = line < 6 ? word(peers, line + 1) : ''
    ms = line < 6 ? 8 : 6
    do for [f = 0:6] {
      family = word(families, f + 1)
      stats rows using (wanted(family, peer, mode) ? column(ms) : NaN) nooutput
      Time[place(m, line, f)] = STATS_median
    }
  }
}
stats rows using 2:3 every ::1 nooutput
count = STATS_max_x
threads = STATS_max_y

# Heights of the names at the lines' ends, in powers of ten: those of the lines, but at least `apart` from each other.
array Height[7]
apart = 0.135
arrange(m) = sum [line = 1:7] (Height[line] = log10(Time[place(m, line - 1, 6)]), 0)
move(low, high) = (gap = apart - Height[high] + Height[low], \
    gap > 0 ? (Height[low] = Height[low] - gap / 2, Height[high] = Height[high] + gap / 2) : 0)
part(m, a, b) = Time[place(m, a - 1, 6)] < Time[place(m, b - 1, 6)] ? move(a, b) : move(b, a)

set terminal svg size 1600,860 dynamic enhanced font face.",22" background "white" linewidth 1
set multiplot
set logscale y
set yrange [0.5:2500]
set xrange [-0.35:6.15]
set border 0
set tics scale 0
set grid ytics linecolor rgb "#DDDDDD" linewidth 1 linetype 1
set tmargin at screen 0.775
set bmargin at screen 0.115
set label 1 sprintf("Finding the overlapping pairs of %d 000 spheres on %s", int(count / 1000), \
    threads == 1 ? "one thread" : sprintf("%d threads", int(threads))) at screen 0.02, 0.95 left font face.",32"
set label 2 "milliseconds, logarithmic: lower is faster" at screen 0.02, 0.885 left textcolor rgb "#555555"

do for [m = 0:1] {
  set lmargin at screen (m ? 0.555 : 0.06)
  set rmargin at screen (m ? 0.86 : 0.40)
  unset xtics
  do for [f = 0:6] {
    set label (10 + f) word(families, f + 1)."\n".word(kinds, f + 1) at first f, graph -0.03 center font face.",19" \
        textcolor rgb "#333333"
  }
  set ytics 1, 10, 1000 format "%g" textcolor rgb "#555555"
  set label 3 (m ? "again, all having moved by 1 % of their radius" : "from bare arrays") at graph 0, 1.03 left font face.",24"
  dummy = arrange(m)
  do for [round = 1:200] { do for [a = 1:6] { do for [b = a + 1:7] { dummy = part(m, a, b) } } }
  do for [line = 0:6] {
    set label (20 + line) name(line) at first 6.25, 10 ** Height[line + 1] left textcolor rgb colour(line) \
        font face.(line < 6 ? ",20" : " Bold,24")
  }
  set print $Drawn  # a row for each family: its place, then all lines
  do for [f = 0:6] {
    text = sprintf("%d", f)
    do for [line = 0:6] { text = text.sprintf(",%g", Time[place(m, line, f)]) }
    print text
  }
  unset print
  plot for [line = 0:6] $Drawn using 1:(column(line + 2)) with linespoints linewidth (line < 6 ? 2.5 : 5) \
      pointtype 7 pointsize (line < 6 ? 0.7 : 1.1) linecolor rgb colour(line) notitle, \
      $Drawn using 1:8:(sprintf(column(8) < 10 ? "%.1f" : "%.0f", column(8))) with labels offset 0, -1.1 \
      font face.",18" textcolor rgb our_colour notitle
  unset label 1  # drawn once is enough
  unset label 2
}
unset multiplot

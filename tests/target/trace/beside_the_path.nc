(A hole, cut beside what is drawn: D is the width of the cut.)
G21 G90 G17 G94 G54
M4 S600 F6000
(The hole, clockwise: its waste is on the right.)
G0 X40 Y35
N10 G42.1 D0.4 G1 X46 Y35
N20 G2 X34 Y35 I-6 J0
N30 G2 X46 Y35 I6 J0
N40 G40 G1 X44 Y33
M5
M2

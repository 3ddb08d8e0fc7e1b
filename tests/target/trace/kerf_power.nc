(A hole by the kerf of 2 mm of CSP 1N, whose table is built in: the power goes with the speed.)
$PC=100:2000
$860=0
G21 G90 G17 G94 G54
M190 P1 Q2
M3 S900 F4000
(Counter-clockwise: its waste is on the left. Corners, an arc, and chords that are welded.)
G0 X50 Y35
G41 G1 X60 Y30
G1 X70
G1 Y36
G3 X64 Y42 I-6 J0
G1 X60 Y40
G1 X50
X49.95 Y39.4
X49.8 Y38.8
X49.5 Y38.2
X49.1 Y37.7
G1 Y30
X60
G40 G1 X55 Y34
M5
M2

(Two tables: a tip goes round a corner of the part while both turn.)
$900=1
$910=3
$911=-4
$912=-60
$913=2
$914=1
$915=-45
G21 G90 G17 G94 G54
G0 X20 Y5 Z0
G43.4 Z12.5
M4 S600 F3000
G1 X25 Y5 Z12.5 A20 C30
G3 X15 Y15 I-10 J0 A25 C120
G1 X-5 Y15 A-10 C200
G49
M5
M2

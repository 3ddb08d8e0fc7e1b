(a circle of radius 20 mm: as one whole turn, then as two half turns)
G21 G90 G17 G54
M4 S0
G0 X40 Y60
G2 X40 Y60 I20 J0 S500 F6000
G2 X80 I20 J0
G2 X40 I-20 J0
M5
G0 X0 Y0
M30

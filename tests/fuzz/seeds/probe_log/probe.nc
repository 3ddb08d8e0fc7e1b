(kerfline probe-grid 1)
(x=0:40 columns=21)
(y=0:40 rows=21)
(pitch X 2 mm, Y 2 mm)
(order: rows along X as a serpentine, from the least X and Y)
(safe=5 depth=-12 feed=60)
(fast-feed=300 retract=1)
(touches=2 tip=2)
M5

// Half of a cylinder of radius 1 (its lower part) and a block, each meshed for itself.
R = 1;
Point(1) = {0, 0, 0, 0.004};
Point(2) = {0, R, 0, 0.25};
Point(3) = {R, R, 0, 0.25};
Point(4) = {R * Sin(Pi / 12), R - R * Cos(Pi / 12), 0, 0.08};
Circle(1) = {1, 2, 4};
Circle(2) = {4, 2, 3};
Line(3) = {3, 2};
Line(4) = {2, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Point(11) = {0, 0, 0, 0.006};
Point(12) = {0, -1, 0, 0.3};
Point(13) = {1, -1, 0, 0.3};
Point(14) = {1, 0, 0, 0.3};
Point(15) = {0.26, 0, 0, 0.12};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 15};
Line(15) = {15, 11};
Curve Loop(11) = {11, 12, 13, 14, 15};
Plane Surface(11) = {11};

Physical Surface("cylinder") = {1};
Physical Surface("block") = {11};
Physical Curve("round") = {1, 2};
Physical Curve("press") = {3};
Physical Curve("middle") = {4, 11};
Physical Curve("flat") = {14, 15};
Physical Curve("ground") = {12};

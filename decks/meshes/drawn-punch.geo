// A punch with a rounded edge on a block with a fillet, half of each, drawn and meshed for itself.
r = 0.3;
Point(1) = {0, 0, 0, 0.15};
Point(2) = {1 - r, 0, 0, 0.06};
Point(3) = {1 - r, r, 0};
Point(4) = {1, r, 0, 0.1};
Point(5) = {1, 1, 0, 0.2};
Point(6) = {0, 1, 0, 0.2};
Line(1) = {1, 2};
Circle(2) = {2, 3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};

f = 0.5;
Point(11) = {0, 0, 0, 0.11};
Point(12) = {0, -1.5, 0, 0.3};
Point(13) = {2, -1.5, 0, 0.3};
Point(14) = {2, -f, 0, 0.2};
Point(15) = {2 - f, -f, 0};
Point(16) = {2 - f, 0, 0, 0.13};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Circle(14) = {14, 15, 16};
Line(15) = {16, 11};
Curve Loop(11) = {11, 12, 13, 14, 15};
Plane Surface(11) = {11};

Physical Surface("punch") = {1};
Physical Surface("block") = {11};
Physical Curve("sole") = {1, 2};
Physical Curve("press") = {4};
Physical Curve("middle") = {5, 11};
Physical Curve("table") = {14, 15};
Physical Curve("ground") = {12};

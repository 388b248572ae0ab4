// A pin in a hole with clearance, the right half of both; each meshed for itself.
R = 1;      // of the hole
c = 0.004;  // radial clearance
Point(1) = {0, -R, 0, 0.06};
Point(2) = {0, 0, 0};
Point(3) = {R, 0, 0, 0.1};
Point(4) = {0, R, 0, 0.2};
Point(5) = {0, 2, 0, 0.4};
Point(6) = {2, 2, 0, 0.4};
Point(7) = {2, -2, 0, 0.4};
Point(8) = {0, -2, 0, 0.3};
Circle(1) = {1, 2, 3};
Circle(2) = {3, 2, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 1};
Curve Loop(1) = {-7, -6, -5, -4, -3, -2, -1};
Plane Surface(1) = {1};

// The pin lies at the bottom of the hole.
Point(11) = {0, -R, 0, 0.045};
Point(12) = {0, -c, 0};
Point(13) = {R - c, -c, 0, 0.08};
Point(14) = {0, R - 2 * c, 0, 0.2};
Point(15) = {0, -c, 0, 0.2};
Circle(11) = {11, 12, 13};
Circle(12) = {13, 12, 14};
Line(13) = {14, 15};
Line(14) = {15, 11};
Curve Loop(11) = {11, 12, 13, 14};
Plane Surface(11) = {11};

Physical Surface("housing") = {1};
Physical Surface("pin") = {11};
Physical Curve("hole") = {1, 2};
Physical Curve("round") = {11, 12};
Physical Curve("middle") = {3, 7, 13, 14};
Physical Curve("ground") = {6};

// Section of a flange with a swing bolt in an open slot, the upper half: stem and flange in one piece with a fillet,
// a gasket below, the bolt beside. Every part is meshed for itself.
h = 0.16;
// half of the stem from x = 0 to 0.5, flange up to x = 3, fillet of radius 0.4
Point(1) = {0, 0.1, 0, h};
Point(2) = {3, 0.1, 0, h};
Point(3) = {3, 1, 0, h};
Point(4) = {0.9, 1, 0, h / 3};
Point(5) = {0.9, 1.4, 0};
Point(6) = {0.5, 1.4, 0, h / 3};
Point(7) = {0.5, 3, 0, h};
Point(8) = {0, 3, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Circle(4) = {4, 5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Plane Surface(1) = {1};

// gasket: a soft sheet under the inner part of the flange
Point(11) = {0, 0, 0, 0.1};
Point(12) = {1.2, 0, 0, 0.1};
Point(13) = {1.2, 0.1, 0, 0.1};
Point(14) = {0, 0.1, 0, 0.1};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(11) = {11, 12, 13, 14};
Plane Surface(11) = {11};

// bolt: shank beside the flange, head above its rim; half of it, cut at its middle
Point(21) = {3.1, 0, 0, 0.15};
Point(22) = {3.5, 0, 0, 0.15};
Point(23) = {3.5, 1.6, 0, 0.15};
Point(24) = {2.5, 1.6, 0, 0.15};
Point(25) = {2.5, 1, 0, 0.1};
Point(26) = {3, 1, 0, 0.07};
Point(27) = {3.1, 1, 0, 0.05};
Line(21) = {21, 22};
Line(22) = {22, 23};
Line(23) = {23, 24};
Line(24) = {24, 25};
Line(25) = {25, 26};
Line(26) = {26, 27};
Line(27) = {27, 21};
Curve Loop(21) = {21, 22, 23, 24, 25, 26, 27};
Plane Surface(21) = {21};

Physical Surface("flange") = {1};
Physical Surface("gasket") = {11};
Physical Surface("bolt") = {21};
Physical Curve("seat") = {1};
Physical Curve("rim") = {3};
Physical Curve("end of the stem") = {6};
Physical Curve("symmetry") = {7};
Physical Curve("upper face") = {13};
Physical Curve("lower face") = {11};
Physical Curve("under the head") = {25, 26};
Physical Curve("middle of the bolt") = {22};
Physical Curve("foot") = {21};

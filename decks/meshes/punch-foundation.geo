// A punch [0, 1] x [0, 1] on a foundation [0, 2] x [-1, 0]. Both bodies share the curve "contact", so their nodes match there;
// each body's list in the deck chooses its own physical surface with `Regions`.
//
// punch:      contact (below), top, left, right
// foundation: contact, free top, bottom, left, right
coarse = 0.15;
fine = 0.05;
Point(1) = {0, 0, 0, coarse};
Point(2) = {1, 0, 0, fine};
Point(3) = {1, 1, 0, coarse};
Point(4) = {0, 1, 0, coarse};
Point(5) = {2, 0, 0, coarse};
Point(6) = {0, -1, 0, coarse};
Point(7) = {2, -1, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {2, 5};
Line(6) = {5, 7};
Line(7) = {7, 6};
Line(8) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {-7, -6, -5, -1, -8};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Curve("contact") = {1};
Physical Curve("top") = {3};
Physical Curve("free top") = {5};
Physical Curve("bottom") = {7};
Physical Curve("left") = {4, 8};
Physical Curve("right") = {2, 6};
Physical Surface("punch") = {1};
Physical Surface("foundation") = {2};

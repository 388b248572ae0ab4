// A quarter of a shaft, 1 <= r <= 2, with a sleeve, 2 <= r <= 3, bonded along the arc r = 2. The arc belongs to both
// surfaces, so their meshes meet there node by node; it is inside the body and therefore no side.
h = 0.2;
Point(1)={0,0,0,h};
Point(11)={1,0,0,h}; Point(12)={0,1,0,h};
Point(21)={2,0,0,h}; Point(22)={0,2,0,h};
Point(31)={3,0,0,h}; Point(32)={0,3,0,h};
Circle(1)={11,1,12}; Circle(2)={21,1,22}; Circle(3)={31,1,32};
Line(4)={11,21}; Line(5)={21,31}; Line(6)={12,22}; Line(7)={22,32};
Curve Loop(1)={4,2,-6,-1}; Plane Surface(1)={1};
Curve Loop(2)={5,3,-7,-2}; Plane Surface(2)={2};
Physical Curve("inside")={1}; Physical Curve("outside")={3};
Physical Curve("bottom")={4,5}; Physical Curve("left")={6,7};
Physical Surface("shaft")={1}; Physical Surface("sleeve")={2};

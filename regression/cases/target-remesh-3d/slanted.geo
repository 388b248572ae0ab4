// A cube that a slanted face cuts into two solids.
SetFactory("OpenCASCADE");
Mesh.MeshSizeMax = 0.6;
Box(1) = {0, 0, 0, 1, 1, 1};
Point(101) = {0, 0, 0.4}; Point(102) = {1, 0, 0.6}; Point(103) = {1, 1, 0.6}; Point(104) = {0, 1, 0.4};
Line(101) = {101, 102}; Line(102) = {102, 103}; Line(103) = {103, 104}; Line(104) = {104, 101};
Curve Loop(101) = {101, 102, 103, 104}; Plane Surface(101) = {101};
BooleanFragments{ Volume{1}; Delete; }{ Surface{101}; Delete; }
e = 1e-4;
lower() = Volume In BoundingBox {-e, -e, -e, 1 + e, 1 + e, 0.6 + e};
upper() = Volume In BoundingBox {-e, -e, 0.4 - e, 1 + e, 1 + e, 1 + e};
Physical Volume("lower") = {lower()};
Physical Volume("upper") = {upper()};
contact() = Surface In BoundingBox {-e, -e, 0.4 - e, 1 + e, 1 + e, 0.6 + e};
Physical Surface("contact") = {contact()};
top() = Surface In BoundingBox {-e, -e, 1 - e, 1 + e, 1 + e, 1 + e};
Physical Surface("top") = {top()};
bottom() = Surface In BoundingBox {-e, -e, -e, 1 + e, 1 + e, e};
Physical Surface("bottom") = {bottom()};
left() = Surface In BoundingBox {-e, -e, -e, e, 1 + e, 1 + e};
Physical Surface("left") = {left()};
front() = Surface In BoundingBox {-e, -e, -e, 1 + e, e, 1 + e};
Physical Surface("front") = {front()};

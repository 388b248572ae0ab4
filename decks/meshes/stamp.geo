// A round stamp on a plate, a quarter of both: they share the disc where they touch.
SetFactory("OpenCASCADE");
Mesh.MeshSizeMax = 0.4;
Mesh.MeshSizeMin = 0.15;
Box(1) = {0, 0, -1, 2, 2, 1};
Cylinder(2) = {0, 0, 0, 0, 0, 1, 0.8, Pi / 2};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("plate") = {1};
Physical Volume("stamp") = {2};
e = 1e-4;
disc() = Surface In BoundingBox {-e, -e, -e, 0.8 + e, 0.8 + e, e};
Physical Surface("disc") = {disc()};
top() = Surface In BoundingBox {-e, -e, 1 - e, 0.8 + e, 0.8 + e, 1 + e};
Physical Surface("top") = {top()};
x() = Surface In BoundingBox {-e, -e, -1 - e, e, 2 + e, 1 + e};
Physical Surface("x") = {x()};
y() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, e, 1 + e};
Physical Surface("y") = {y()};
base() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, 2 + e, -1 + e};
Physical Surface("base") = {base()};

// contact-loss-3d from one script: a plate on a foundation share a face, and the pressed quarter of the top is drawn.
SetFactory("OpenCASCADE");
If (!Exists(h)) h = 0.5; EndIf
Mesh.MeshSizeMax = h;
Box(1) = {0, 0, 0, 1, 1, 0.5};
Box(2) = {0, 0, -1, 2, 2, 1};
Rectangle(100) = {0, 0, 0.5, 0.5, 0.5};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Surface{100}; Delete; }
e = 1e-4;
Physical Volume("upper") = {1};
Physical Volume("lower") = {2};
contact() = Surface In BoundingBox {-e, -e, -e, 1 + e, 1 + e, e};
Physical Surface("contact") = {contact()};
top() = Surface In BoundingBox {-e, -e, 0.5 - e, 1 + e, 1 + e, 0.5 + e};
Physical Surface("top") = {top()};
ground() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, 2 + e, -1 + e};
Physical Surface("ground") = {ground()};
x() = Surface In BoundingBox {-e, -e, -1 - e, e, 2 + e, 1 + e};
Physical Surface("x") = {x()};
y() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, e, 1 + e};
Physical Surface("y") = {y()};

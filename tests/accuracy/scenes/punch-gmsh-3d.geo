// punch-3d from one script: a block on a foundation share a face.
SetFactory("OpenCASCADE");
If (!Exists(h)) h = 0.5; EndIf
Mesh.MeshSizeMax = h;
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {0, 0, -1, 2, 2, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
e = 1e-4;
Physical Volume("punch") = {1};
Physical Volume("foundation") = {2};
contact() = Surface In BoundingBox {-e, -e, -e, 1 + e, 1 + e, e};
Physical Surface("contact") = {contact()};
top() = Surface In BoundingBox {-e, -e, 1 - e, 1 + e, 1 + e, 1 + e};
Physical Surface("top") = {top()};
ground() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, 2 + e, -1 + e};
Physical Surface("ground") = {ground()};
x() = Surface In BoundingBox {-e, -e, -1 - e, e, 2 + e, 1 + e};
Physical Surface("x") = {x()};
y() = Surface In BoundingBox {-e, -e, -1 - e, 2 + e, e, 1 + e};
Physical Surface("y") = {y()};

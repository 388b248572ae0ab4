// decks/punch.xml, finer towards the end of contact and the clamped corner. At a corner u grows like r^0.77, and the
// energy error of second-order triangles is spread evenly when their size grows like r^0.74.
Point(1) = {0, -1, 0}; Point(2) = {2, -1, 0}; Point(3) = {2, 0, 0}; Point(4) = {1, 0, 0};
Point(5) = {0, 0, 0}; Point(6) = {1, 1, 0}; Point(7) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 1};
Line(6) = {4, 6}; Line(7) = {6, 7}; Line(8) = {7, 5};
Curve Loop(1) = {1, 2, 3, 4, 5}; Plane Surface(1) = {1};
Curve Loop(2) = {-4, 6, 7, 8}; Plane Surface(2) = {2};
Physical Surface("foundation") = {1}; Physical Surface("punch") = {2};
Physical Curve("bottom") = {1}; Physical Curve("left") = {5, 8}; Physical Curve("contact") = {4}; Physical Curve("top") = {7};

Field[1] = MathEval; Field[1].F = "0.1 * ((x - 1)^2 + y^2 + 1e-14)^0.37";
Field[2] = MathEval; Field[2].F = "0.25 * ((x - 2)^2 + (y + 1)^2 + 1e-10)^0.37";
Field[3] = Min; Field[3].FieldsList = {1, 2};
Background Field = 3;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0; Mesh.Algorithm = 6;
